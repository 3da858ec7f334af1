// Every render target of the pack.
//
// target       format    size    clear  written by                    read by
// colortex0    RGBA16F   window  0      sky, deferred6, translucent   deferred6, final
//   linear radiance, before exposure; RGBA32F where colortex3 is
// colortex1    RGBA8     window  0      opaque gbuffers               deferred, deferred1, 2, 6
//   rgb albedo as textured (sRGB), a material byte (include/gbuffer.glsl)
// colortex2    RGBA8     window  0      opaque gbuffers               deferred, deferred1, 2, 6
//   rg normal, octahedral, world axes; b block light, a sky light (0..1)
// colortex3    RGBA16F   window  keep   deferred2                     deferred2 (next frame), deferred3
//   rgb mean incoming radiance over the hemisphere, a number of frames in it;
//   RGBA32F from 256 frames on, where half floats stop moving
// colortex4    RGBA16F   atlas   keep   prepare                       prepare, deferred, translucent
//   floodfill light by cell (include/voxels/volume.glsl); RGBA32F with FLOODFILL_RULE=CONSERVING,
//   whose steps become too small for half floats long before it is done. With
//   FLOODFILL_STORAGE=IMAGE_3D the image flood_light is instead
// colortex5    RGBA16F   window  keep   deferred2                     deferred2 (next frame), filter
//   the plane that colortex3 belongs to (include/plane.glsl); w with GI_FILTER: the noise of colortex3 (include/gi/noise.glsl)
// colortex6    RGBA16F   window  0      deferred3, 4, 5               deferred4, 5, 6
//   rgb of colortex3 smoothed, a its noise; kept where the picture rests (include/gi/rest.glsl)
// shadowcolor0 RGBA8     shadow  0      shadow                        prepare, deferred, deferred1, translucent
//   voxels in the bottom rows (include/voxels/voxel.glsl), above them what the surface nearest to the light
//   takes of it (include/shadow/sheets.glsl)
// shadowtex0   depth     shadow  1      shadow                        shadowcomp7, deferred, deferred6, translucent
//   shadow map with translucent blocks: how far light goes through water
// shadowtex1   depth     shadow  1      shadow                        deferred, deferred6, translucent
//   shadow map without translucent blocks, above the rows of the voxels
// colortex7    RGBA32F   window  0      opaque gbuffers               deferred6
//   with LIGHT_METHOD=FORWARD: radiance that the surface reflects of lamps
// colortex8    RGBA16F   window  keep   deferred2                     deferred2 (next frame), deferred6
//   with GI_GLOSSY: rgb what polished blocks and metals mirror, a number of frames in it; RGBA32F
//   where colortex3 is
// colortex9    R32F      1x1     keep   composite                     composite (next frame), final
//   with AUTO_EXPOSURE: the exposure
// colortex10   RGBA16F   window  keep   deferred2                     translucent
// colortex11   RGBA16F   window  keep   deferred2                     translucent
//   with TEMPORAL_ACCUMULATION, but not with floodfill: colortex12 and 13 of the frame before; a plane of 0 where it drew nothing
// colortex12   RGBA16F   window  keep   translucent                   deferred2 (next frame)
//   with TEMPORAL_ACCUMULATION: what colortex3 is, for the nearest translucent surface; RGBA32F where that is
// colortex13   RGBA16F   window  keep   translucent                   deferred2 (next frame)
//   with TEMPORAL_ACCUMULATION: the plane that colortex12 belongs to; w: the frame that drew it
//   (include/gi/history.glsl)
// colortex14   RGBA16F   window  keep   deferred                      deferred2
// colortex15   RGBA16F   window  keep   deferred1                     deferred2
//   rgb this frame's samples by rays into the hemisphere, and by rays to lamps (include/gi/turns.glsl)
//
// The images of the lamps are described in include/lights, those of the face cache in
// include/face_cache/face_cache.glsl, those that are made of the voxels in include/voxels/: changes, distance,
// flood_image, active_bricks.
// colortex3..15 and the shadow targets exist only while an option uses them.
#if !defined INCLUDED_BUFFERS
#define INCLUDED_BUFFERS

#if HAS_LONG_MEANS
/*
const int colortex0Format = RGBA32F;
*/
#else
/*
const int colortex0Format = RGBA16F;
*/
#endif
/*
const vec4 colortex0ClearColor = vec4(0.0, 0.0, 0.0, 0.0);
const int colortex1Format = RGBA8;
const vec4 colortex1ClearColor = vec4(0.0, 0.0, 0.0, 0.0);
const int colortex2Format = RGBA8;
*/

#if HAS_VOXELS
#if HAS_LONG_MEANS
/*
const int colortex3Format = RGBA32F;
*/
#else
/*
const int colortex3Format = RGBA16F;
*/
#endif
/*
const bool colortex3Clear = false;
const int colortex5Format = RGBA16F;
const int colortex6Format = RGBA16F;
const bool colortex5Clear = false;
const int shadowcolor0Format = RGBA8;
const vec4 shadowcolor0ClearColor = vec4(0.0, 0.0, 0.0, 0.0);
*/
#endif

#if HAS_GI
/*
const int colortex14Format = RGBA16F;
const int colortex15Format = RGBA16F;
const bool colortex14Clear = false;
const bool colortex15Clear = false;
*/
#endif

#if HAS_TRANSLUCENT_MEANS
#if HAS_LONG_MEANS
/*
const int colortex10Format = RGBA32F;
const int colortex12Format = RGBA32F;
*/
#else
/*
const int colortex10Format = RGBA16F;
const int colortex12Format = RGBA16F;
*/
#endif
/*
const bool colortex10Clear = false;
const bool colortex12Clear = false;
const int colortex11Format = RGBA16F;
const bool colortex11Clear = false;
const int colortex13Format = RGBA16F;
const bool colortex13Clear = false;
*/
#endif

#if HAS_REST
/*
const bool colortex6Clear = false;
*/
#endif

#if HAS_GLOSSY
#if HAS_LONG_MEANS
/*
const int colortex8Format = RGBA32F;
*/
#else
/*
const int colortex8Format = RGBA16F;
*/
#endif
/*
const bool colortex8Clear = false;
*/
#endif

#if HAS_AUTO_EXPOSURE
/*
const int colortex9Format = R32F;
const bool colortex9Clear = false;
*/
#endif

#if HAS_FORWARD_LAMPS
/*
const int colortex7Format = RGBA32F;
*/
#endif

#if HAS_AIR_LIGHT && !HAS_FLOOD_IMAGE
#if FLOODFILL_RULE == FLOODFILL_RULE_CONSERVING
/*
const int colortex4Format = RGBA32F;
*/
#else
/*
const int colortex4Format = RGBA16F;
*/
#endif
/*
const bool colortex4Clear = false;
*/
#endif

#endif
