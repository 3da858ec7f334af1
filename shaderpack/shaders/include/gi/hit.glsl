// What a ray finds at the block it hits.
#if !defined INCLUDED_GI_HIT
#define INCLUDED_GI_HIT

#include "/include/shadow/shadow.glsl"
#include "/include/sky/sky.glsl"
#include "/include/gi/thin.glsl"
#include "/include/sun/sun_tint.glsl"
#include "/include/math/sampling.glsl"
#include "/include/voxels/trace.glsl"

// Rays begin a little off their face, in blocks: no more, as a floor that is .02 nearer to a lamp on it gets 4 % less light
// from it. Points of faces that rays have hit are exact.
const float face_offset = 0.001;

/// Off what a pixel shows, more than its depth rounds. `player`: player space.
float pixel_offset(vec3 player) { return min(0.02, face_offset + 2e-5 * dot(player, player)); }

// Of what a plane of a portal gives this leaves its cell by each of the four sides beside it.
const float portal_aside = 0.1225;

// Of lines that come into a cell of fire as many meet a plane of it as if so many lay behind each other, with holes of their own: of
// lines from beside it, from above and from below.
const vec3 planes_of_fire = vec3(1.56, 0.55, 2.0);

/// How much brighter the planes of a portal or of fire are than the cube that stands for it: as much light leaves its cell. That
/// which falls on what is beside it, as the frame of a portal, does not; nor does that of sides of the cube which lie there or on
/// other lamps.
float boost_of_planes(ivec3 cell, int code) {
    vec3 across = is_portal(code) ? partition_axis(code) : vec3(0.0);
    vec3 of_fire = 1.0 - pow(vec3(open_share(holes_of_plane(code))), planes_of_fire);
    float open = 0.0;
    float shown = 0.0;
    // Of no other lamp: drivers unroll loops whose length they know.
    int faces = has_planes_of_lamp(code) ? 6 : 0;
    for (int face = 0; face < faces; ++face) {
        vec3 normal = face_normal(face);
        int beside = voxel_at(cell + ivec3(normal)).code;
        bool own_side = dot(normal, across) != 0.0;
        float of_side = normal.y > 0.0 ? of_fire.y : normal.y < 0.0 ? of_fire.z : of_fire.x;
        bool full = is_full(beside) && !own_side;
        open += float(own_side || (!full && !has_planes_of_lamp(beside)));
        shown += own_side ? 1.0 : is_fire(code) ? float(!full) * of_side : -2.0 * portal_aside * float(full);
    }
    return open / max(shown, 1e-3);
}

/// Radiance of a lamp where a ray hits it: small ones are balls.
vec3 lamp_light(Voxel v, ivec3 cell) {
    float boost = is_ball(v.code) ? small_lamp_boost : 1.0;
    if (has_planes_of_lamp(v.code)) boost = boost_of_planes(cell, v.code);
    return lamp_radiance(v) * boost;
}

/// What a ray gets of the lamp that it hits; 0: it hits none, or what is drawn of a small one beside its ball.
vec3 lamp_light(Hit hit, vec3 from, vec3 direction) {
    bool beside = is_ball(hit.voxel.code) && !meets_ball(hit.cell, from, direction);
    return is_lamp_voxel(hit.voxel.code) && !beside ? lamp_light(hit.voxel, hit.cell) : vec3(0.0);
}

/// Does a ray go on behind the small lamp that it hits? What is drawn of that stops it, its ball does not.
bool goes_on(Hit hit) { return hit.found && is_ball(hit.voxel.code) && !hit.inner; }

/// Is a hit on what is drawn of a small lamp?
bool is_on_body(Hit hit) { return is_ball(hit.voxel.code) && hit.inner; }

/// What a hit sends back. Of bodies of lamps voxels know the light alone: iron and wood have some of its colour.
vec3 albedo_of(Hit hit) { return is_on_body(hit) ? 0.3 * sqrt(brightest(hit.voxel.color)) : voxel_albedo(hit.voxel); }

/// Of a ray that goes on, the place where it is nearest to the middle of the lamp.
vec3 point_in_ball(Hit hit, vec3 from, vec3 direction) {
    return from + direction * dot(vec3(hit.cell) + 0.5 - from, direction);
}

#if !HAS_VOXEL_CHANGES
// Share of a side of leaves that is open.
const float leaf_holes = 0.09;
#endif

/// The first block of a ray from a face.
Hit trace_from_face(vec3 origin, vec3 direction) {
    Voxel own = voxel_at(ivec3(floor(origin)));
    Hit hit = trace(origin, direction, own.code, ray_from_face);
#if !HAS_VOXEL_CHANGES
    // Of full blocks leaves alone are looked out of: without a picture of their holes they pass light on as if it went
    // straight on.
    if (own.code == voxel_solid) hit.transmittance *= mix(own.color, vec3(1.0), leaf_holes);
#endif
    return hit;
}

/// Of a ray that has left the volume: none in a cave, where neither the place of leaving gets light of the sky nor that
/// where the ray began: `sky`, the level there.
vec3 sky_beyond(Hit hit, vec3 direction, float sky) {
    return sky_radiance(direction) * (sky_comes_to(hit.position) ? 1.0 : smoothstep(0.0, 0.1, sky));
}

/// Has a ray passed the first side of a pane, and met the second?
bool is_within_pane(Hit hit) {
    return is_pane(hit.voxel.code) && dot(hit.position - vec3(hit.cell) - 0.5, hit.normal) < 0.0;
}

// Glass that passes less of a colour parts what lies before it from what lies behind it.
const float least_passed = 0.05;

/// Has a ray hit a face within stained glass, or what lies between the sides of a pane, on a face whose halves lie beside it?
bool is_within_glass(Hit hit) {
    ivec3 before = hit.cell + ivec3(hit.normal);
    Voxel glass = voxel_at(before);
    vec3 axis = parted_axis(glass.code, before);
    bool between = axis != vec3(0.0) && abs(dot(hit.position - vec3(before) - 0.5, axis)) < pane_radius;
    bool stained = glass.code == voxel_translucent && min(glass.color.r, min(glass.color.g, glass.color.b)) < least_passed;
    return between || stained;
}

/// Does the light on a hit differ too much over its face for the mean to stand for it? Glass and panes have two layers: what
/// comes through the holes of one is reflected to and fro between them, and the face has the light on the outside. A small lamp
/// has no faces.
bool is_ill_known(Hit hit) {
    return is_on_body(hit) || is_glass(hit.voxel.code) || is_within_pane(hit) || is_within_glass(hit);
}

#if HAS_SHADOW_MAP
/// What translucent voxels leave of light that comes to a point, as far as `reach` from it. The map knows the first side that the
/// light meets and no paths, and a texel of it may be as wide as the part of a face that a pane shades.
vec3 tint_along(vec3 point, vec3 light, float reach) {
    Walk walk = begin_walk(point, light);
    vec3 tint = vec3(1.0);
    int last_code = voxel_at(cell_of(walk)).code;
    vec2 span = vec2(0.0);
    int i = 0;
    if (reach > 0.0 && in_volume(cell_of(walk))) do {
        Voxel voxel = voxel_at(cell_of(walk));
        span = max(span_in_cell(walk), 0.0);
        vec2 within = span;
        if (voxel.code == voxel_water_surface)
            within = below_surface(span, walk.cell.y + water_height - point.y, light.y);
        float depth = filter_depth(voxel.code, voxel.code == last_code, walk.cell + 0.5 - point, walk.inverse, within);
        tint *= is_filter_voxel(voxel.code) ? filtered(voxel.color, depth) : vec3(1.0);
        last_code = voxel.code;
        leave_cube(walk, 1.0);
    } while (++i < 3 * VOLUME && span.y < reach && in_volume(cell_of(walk)));
    return tint;
}

/// Share of the sun's light that arrives at a hit. Where the edge of a shadow lies between the texels of the map about the
/// point, what throws the shadow, if it is a block whose shape voxels have, says itself what it stops: the map's edges, where
/// they follow its rows, are off by up to half a texel all along, so that a beam through a narrow opening is too wide or
/// too narrow. `sky`: level where the ray began.
vec3 sun_share(Hit hit, vec3 light, float sky) {
    PlaneInMap plane = plane_in_map(from_volume(hit.position), hit.normal);
    vec3 texel = vec3(floor(plane.position), 0.0);
    texel.z = depth_in_texel(plane, texel.xy);
    float lit = point_visibility(plane, texel.z, sky);
    vec3 from = hit.position + hit.normal * face_offset;
#if SHADOW_COMPARE == SHADOW_COMPARE_TEXEL
    EdgeInMap edge = edge_in_map(plane);
    vec3 caster = to_volume(edge.caster - 0.002 * light);
    ivec3 cell = ivec3(floor(caster));
    bool is_exact = edge.found && cell != ivec3(floor(from)) && octants_of(voxel_at(cell).code, cell) != 0u;
    bool boxes = false;
#if HAS_VOXEL_CHANGES
    // The map's texels are wider than the frame of glass is, and as wide as a pane is thick.
    bool beside_glass = is_clear(voxel_at(ivec3(floor(from))).code);
    // A side may be as far behind the map's depth as it is aslant within a quarter of a texel.
    bool by_glass = edge.dark && is_clear(voxel_at(ivec3(floor(caster - 0.1 * light))).code);
    bool near_pane = by_glass && is_pane(voxel_at(cell).code) && (beside_glass || distance(caster, from) < 0.5);
    is_exact = is_exact || by_glass;
    boxes = near_pane || beside_glass;
#endif
    bool passes = !is_stopped(from, light, is_exact, boxes);
    texel = is_exact && passes && edge.found ? edge.lit : texel;
    lit = is_exact ? float(passes) : lit * float(passes);
#endif
    vec3 share = vec3(lit);
    if (lit > 0.0) {
        Voxel before = voxel_at(hit.cell + ivec3(hit.normal));
        bool beside_stained = is_tinted_pane(before.code);
        vec3 mapped = point_tint(ivec2(texel.xy), texel.z, before);
        bool is_tinted = mapped != vec3(1.0);
        // To the first side and through its block.
        float reach = is_tinted ? blocks_below(sheet_texel(ivec2(texel.xy)), texel.z) + 2.0 : beside_stained ? 2.0 : 0.0;
        vec3 tint = tint_along(from, light, reach);
        // What is next to the edge of a window may get light by a texel of the map that the voxels know nothing of.
        share *= beside_stained || tint != vec3(1.0) ? tint : mapped;
    }
    return share;
}
#else
vec3 sun_share(Hit hit, vec3 light, float sky) { return vec3(unmapped_visibility(sky)); }
#endif

/// Sun or moon light that a hit reflects or, if it is thin, lets pass to where the ray came from, without its albedo. `sky`: level
/// where the ray began.
vec3 sun_at(Hit hit, vec3 direction, vec3 light, float sky) {
    float slope = dot(hit.normal, light);
    vec3 share = vec3(1.0);
    if (is_thin(hit.voxel.code)) {
        if (slope * dot(hit.normal, direction) > 0.0) share = passed_share(hit.voxel.color);
        hit.normal *= slope < 0.0 ? -1.0 : 1.0;
        slope = abs(slope);
    }
    return light_irradiance() * share * (max(slope, 0.0) / pi) * sun_share(hit, light, sky);
}

#endif
