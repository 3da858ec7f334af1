/* Orris for engines: draws blocks with shader packs made for Iris, in the engine's own GL context.
 * C99 and C++; link liborris.so (pkg-config orris). docs/embedding.md is a guide.
 *
 * Rules that hold for every function:
 *   Errors    Functions return an OrrisStatus; orris_last_error() has the words. Nothing is thrown, printed
 *             or ended, and nothing is done when the status is not ORRIS_OK, but where a function says so.
 *   Handles   NULL, a destroyed handle and one of another kind are ORRIS_ERROR_HANDLE. Whoever creates a
 *             handle destroys it.
 *   Threads   One thread at a time may be inside the library, whatever the handles: GL functions are those
 *             of one context at a time. Calls with a context or a renderer come on the thread on which the
 *             engine's context is current; those of a context of orris_context_create() on the thread that
 *             made it, where each call leaves it current.
 *   Strings   UTF-8, ended by 0. Strings that are handed in are copied. Strings that come out belong to
 *             Orris and live until the next call with the same handle, if nothing else is said.
 *   Structs   Fill `struct_size` through the function that initialises the struct, or set it to its sizeof.
 *   Space     World: blocks, x east, y up, z south. Player space: the same axes, the eye at the origin.
 *             Matrices are column-major, 16 floats, in OpenGL's conventions (depth -1 to 1).
 *   Colours   Pixels and vertex colours are display values (sRGB), as the game's textures are.
 */
#ifndef ORRIS_ORRIS_H
#define ORRIS_ORRIS_H

#include <stddef.h>
#include <stdint.h>

/** Raised by each change that is not an addition; the soname of the library is liborris.so.<this>. */
#define ORRIS_API_VERSION 1

#if defined(__GNUC__)
#define ORRIS_API __attribute__((visibility("default")))
#else
#define ORRIS_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

typedef enum OrrisStatus {
  ORRIS_OK = 0,
  ORRIS_ERROR_ARGUMENT = 1,  /**< a null pointer, a value out of its range, a struct of another size */
  ORRIS_ERROR_HANDLE = 2,    /**< no handle of this kind, or destroyed */
  ORRIS_ERROR_CONTEXT = 3,   /**< no GL context is current, or it lacks what drawing needs */
  ORRIS_ERROR_PACK = 4,      /**< the pack cannot be drawn; see the diagnostics. The last good one stays */
  ORRIS_ERROR_WORLD = 5,     /**< the world cannot be read; see the diagnostics */
  ORRIS_ERROR_ORDER = 6,     /**< not allowed now: before the first frame, inside a callback, and so on */
  ORRIS_ERROR_NOT_FOUND = 7, /**< the pack has nothing of that name or number */
  ORRIS_ERROR_MEMORY = 8,    /**< no memory */
  ORRIS_ERROR_INTERNAL = 9   /**< a mistake of Orris; the handle should be destroyed */
} OrrisStatus;

/** A GL context. Renderers made with it share compiled programs. */
typedef struct OrrisContext OrrisContext;
/** A pack that draws frames of one size; several may live in one context. */
typedef struct OrrisRenderer OrrisRenderer;

/* ---- Library ------------------------------------------------------------------------------------ */

/** ORRIS_API_VERSION of the library that was loaded; compare it with that of the header. */
ORRIS_API uint32_t orris_api_version(void);
/** Version of Orris, "0.1.0"; lives as long as the program. */
ORRIS_API const char* orris_version(void);
/** Name of a status, "ORRIS_ERROR_PACK"; lives as long as the program. "unknown" for no status. */
ORRIS_API const char* orris_status_name(OrrisStatus status);
/** Why the last call on this thread that did not return ORRIS_OK failed; "" when none has. Lives until the
 *  next call on this thread. */
ORRIS_API const char* orris_last_error(void);

/* ---- Contexts ----------------------------------------------------------------------------------- */

/** Address of a GL function by its name ("glClear"), or NULL. */
typedef void* (*OrrisGetProcAddress)(const char* name, void* user);

/** Takes the context that is current on this thread, OpenGL 4.3 or newer with direct state access, of
 *  either profile; it stays the engine's. `get_proc_address` must stay callable as long as the handle lives.
 *  Every call afterwards leaves GL state as it was (docs/embedding.md lists the exceptions). GL debug
 *  messages go to Orris until the handle is destroyed.
 *  Errors: CONTEXT when none is current or it lacks something. */
ORRIS_API OrrisStatus orris_context_adopt(OrrisGetProcAddress get_proc_address, void* user,
                                          OrrisContext** out);

/** Makes a context without a window, for programs that have none. `backend`: "auto" (NULL is the same),
 *  "osmesa" or "egl". It is current afterwards. Errors: ARGUMENT for another name, CONTEXT. */
ORRIS_API OrrisStatus orris_context_create(const char* backend, OrrisContext** out);

/** What the driver is, read once. The strings live as long as the context. */
typedef struct OrrisContextFacts {
  uint32_t struct_size;
  const char* backend;  /**< "adopted", "osmesa" or "egl" */
  const char* vendor;
  const char* renderer;
  const char* version;
  int32_t gl_version;   /**< 450 */
  int32_t core_profile; /**< 1: without the old fixed functions */
  int32_t max_texture_size, max_texture_units, max_draw_buffers, max_image_units;
} OrrisContextFacts;
/** `facts->struct_size` must be set. */
ORRIS_API OrrisStatus orris_context_facts(OrrisContext* context, OrrisContextFacts* facts);

/** The context itself stays where it was adopted. Errors: ORDER while a renderer of it lives. */
ORRIS_API OrrisStatus orris_context_destroy(OrrisContext* context);

/* ---- Renderers ---------------------------------------------------------------------------------- */

typedef enum OrrisSeverity { ORRIS_NOTE = 0, ORRIS_WARNING = 1, ORRIS_ERROR = 2 } OrrisSeverity;

/** One problem of a pack or a world; valid during the callback. */
typedef struct OrrisDiagnostic {
  uint32_t struct_size;
  OrrisSeverity severity;
  const char* id;       /**< stable, "include-missing"; docs/checks.md */
  const char* file;     /**< path in the pack, "/lib/sky.glsl"; "" for none */
  int32_t line, column; /**< from 1; 0 unknown */
  const char* message;
  const char* hint;     /**< what to do; may be "" */
  const char* text;     /**< all of it with the source line, as the command prints it */
} OrrisDiagnostic;
/** Called during the call that found the problem; no function of Orris may be called in it. */
typedef void (*OrrisDiagnosticCallback)(const OrrisDiagnostic* diagnostic, void* user);

typedef struct OrrisRendererRequest {
  uint32_t struct_size;
  int32_t width, height;      /**< pixels, 1 to 16384 */
  const char* pack;           /**< a folder or a zip */
  const char* world;          /**< a world of Orris's formats; NULL: the engine submits geometry */
  const char* dimension;      /**< "minecraft:the_nether"; NULL: the world's, or the overworld */
  const char* profile;        /**< of the pack; NULL: none */
  const char* const* options; /**< "NAME=VALUE", `option_count` of them; NULL: defaults */
  uint32_t option_count;
  uint32_t kinds; /**< of an engine's geometry, bits ORRIS_KIND_BIT(): compiled at once, others when first
                       submitted */
  uint32_t seed;  /**< of worlds and noise */
  OrrisDiagnosticCallback on_diagnostic; /**< may be NULL */
  void* user;                            /**< for the callback */
} OrrisRendererRequest;

/** Defaults: 1280x720, no pack. `size` is sizeof(OrrisRendererRequest). A NULL pointer is ignored. */
ORRIS_API void orris_renderer_request_init(OrrisRendererRequest* request, size_t size);

/** Loads the pack and compiles its programs: seconds, for large packs.
 *  Errors: ARGUMENT, CONTEXT, PACK, WORLD, MEMORY. */
ORRIS_API OrrisStatus orris_renderer_create(OrrisContext* context, const OrrisRendererRequest* request,
                                            OrrisRenderer** out);
/** Frees everything of it; its context must be current. */
ORRIS_API OrrisStatus orris_renderer_destroy(OrrisRenderer* renderer);
/** Reads the pack's files again; programs whose text is the same stay. Errors: PACK, ORDER. */
ORRIS_API OrrisStatus orris_renderer_reload(OrrisRenderer* renderer);
/** What the pack gathered over frames begins anew. Errors: ARGUMENT (1 to 16384), PACK, ORDER. */
ORRIS_API OrrisStatus orris_renderer_resize(OrrisRenderer* renderer, int32_t width, int32_t height);
/** Programs of another dimension, "minecraft:the_end". Errors: PACK, ORDER. */
ORRIS_API OrrisStatus orris_renderer_set_dimension(OrrisRenderer* renderer, const char* dimension);

/* ---- Options ------------------------------------------------------------------------------------ */

typedef struct OrrisOption {
  uint32_t struct_size;
  const char* name;
  const char* value;         /**< in force */
  const char* default_value;
  const char* comment;       /**< of the author, may be "" */
  int32_t is_boolean;        /**< values "true" and "false" */
  uint32_t value_count;      /**< allowed ones, orris_renderer_option_value() */
} OrrisOption;

/** Number of options, which are numbered from 0 in the order of their names. */
ORRIS_API OrrisStatus orris_renderer_option_count(OrrisRenderer* renderer, uint32_t* out);
/** `option->struct_size` must be set. The strings live until options, profile or pack change.
 *  Errors: NOT_FOUND. */
ORRIS_API OrrisStatus orris_renderer_option(OrrisRenderer* renderer, uint32_t index, OrrisOption* option);
/** An allowed value of an option, in the author's order. Errors: NOT_FOUND. */
ORRIS_API OrrisStatus orris_renderer_option_value(OrrisRenderer* renderer, uint32_t index, uint32_t value,
                                                  const char** out);
/** Compiles what the option reaches. Errors: NOT_FOUND for the option, ARGUMENT for a value that is not
 *  allowed, PACK, ORDER. */
ORRIS_API OrrisStatus orris_renderer_set_option(OrrisRenderer* renderer, const char* name,
                                                const char* value);
ORRIS_API OrrisStatus orris_renderer_profile_count(OrrisRenderer* renderer, uint32_t* out);
/** Name of a profile. Errors: NOT_FOUND. */
ORRIS_API OrrisStatus orris_renderer_profile_name(OrrisRenderer* renderer, uint32_t index,
                                                  const char** out);
/** The profile whose values are in force; "" when they are of none. */
ORRIS_API OrrisStatus orris_renderer_profile(OrrisRenderer* renderer, const char** out);
/** Options set by orris_renderer_set_option() stay above it. Errors: NOT_FOUND, PACK, ORDER. */
ORRIS_API OrrisStatus orris_renderer_set_profile(OrrisRenderer* renderer, const char* name);

/* ---- Frames ------------------------------------------------------------------------------------- */

typedef enum OrrisCameraMode {
  ORRIS_CAMERA_ANGLES = 0,    /**< yaw, pitch, fov */
  ORRIS_CAMERA_DIRECTION = 1, /**< direction, fov */
  ORRIS_CAMERA_MATRICES = 2   /**< view, projection */
} OrrisCameraMode;

/** The eye. Position in blocks of the world, in all modes. */
typedef struct OrrisCamera {
  OrrisCameraMode mode;
  double position[3];
  float yaw, pitch;     /**< degrees: yaw 0 looks south, 90 west; pitch 90 looks down */
  float fov;            /**< vertical, degrees, over 0 and under 180 */
  float direction[3];   /**< world axes, any length but 0 */
  float view[16];       /**< player space to view space: a rotation, bobbing allowed */
  float projection[16]; /**< view space to clip space */
} OrrisCamera;

/** What the pack sees of the moment; all of it is copied. Everything has a default. */
typedef struct OrrisFrame {
  uint32_t struct_size;
  OrrisCamera camera;
  float frame_time;        /**< seconds since the frame before */
  int32_t time, day;       /**< ticks 0 to 23999 (0 sunrise, 6000 noon), days */
  float rain, thunder;     /**< 0 to 1 */
  int32_t render_distance; /**< blocks, uniform `far` */
  int32_t clouds;          /**< of Orris: 0 none, 1 flat, 2 boxes; the pack may decide otherwise */
  const char* biome;       /**< "minecraft:plains" */
  float temperature, rainfall;
  float sky_color[3], fog_color[3]; /**< of the air by day; Orris darkens them at night */
  /* The player. */
  const char* main_hand;   /**< item, "minecraft:torch"; "" for none. heldItemId */
  const char* off_hand;
  int32_t held_light, held_light2; /**< 0 to 15, of both hands */
  float blindness, night_vision, darkness, darkness_light; /**< effects, 0 to 1 */
  float screen_brightness; /**< the game's setting, 0 to 1 */
  int32_t sneaking, sprinting, hurt, invisible, burning, on_ground, hide_gui; /**< 0 or 1 */
  /* Of an engine's geometry only; otherwise the world knows it. */
  const char* selected_block;   /**< the one that is looked at, "minecraft:chest[facing=north]"; "" for none */
  double selected_position[3];  /**< its middle, world */
  int32_t lightning;            /**< 1: a bolt strikes */
  double lightning_position[3]; /**< world */
  int32_t eye_fluid;       /**< 0 none, 1 water, 2 lava */
  int32_t feet_in_water;   /**< 0 or 1 */
  int32_t eye_block_light, eye_sky_light; /**< 0 to 15 */
} OrrisFrame;

/** What the next frame shows if nothing is changed: camera, time and weather of the world, which its events
 *  move, or of the frame before. `size` is sizeof(OrrisFrame). The strings live until the next frame. */
ORRIS_API OrrisStatus orris_renderer_frame_init(OrrisRenderer* renderer, OrrisFrame* frame, size_t size);

/** States a uniform of what Orris cannot know, "currentPlayerHealth" or "currentTime", from the next frame on;
 *  docs/world-format.md lists them. `count` is 1, or 3 of a vector; 0 or 1 of a bool, whole numbers of an int.
 *  Errors: NOT_FOUND for another name, ARGUMENT for numbers that it cannot have. */
ORRIS_API OrrisStatus orris_renderer_set_uniform(OrrisRenderer* renderer, const char* name, const float* values,
                                                 size_t count);

/** Draws a frame of what was submitted, or of the world; NULL: as orris_renderer_frame_init() gives it.
 *  What was submitted is used up. Errors: ARGUMENT for a number out of its range or not finite, and then
 *  nothing is drawn; PACK when programs that the frame needs cannot be made: it is drawn without them. */
ORRIS_API OrrisStatus orris_renderer_draw_frame(OrrisRenderer* renderer, const OrrisFrame* frame);

/** The last frame into colour of a framebuffer of the engine (0: the window), scaled to the rectangle, in
 *  pixels from its lower left corner. Depth is not written. Errors: ARGUMENT, ORDER before the first frame. */
ORRIS_API OrrisStatus orris_renderer_output(OrrisRenderer* renderer, uint32_t framebuffer, int32_t x,
                                            int32_t y, int32_t width, int32_t height);
/** The last frame as RGBA, 8 bits each, top row first, alpha 255; `bytes` must be width*height*4.
 *  Errors: ARGUMENT for another number of bytes, ORDER before the first frame. */
ORRIS_API OrrisStatus orris_renderer_read(OrrisRenderer* renderer, void* rgba, size_t bytes);
/** GL name of a 2-D texture of the last frame: "screen", "colortex0", "depthtex0", "shadowtex0", ...; it is
 *  Orris's and changes with each frame, load and resize. Errors: NOT_FOUND, ORDER before the first frame. */
ORRIS_API OrrisStatus orris_renderer_texture(OrrisRenderer* renderer, const char* name, uint32_t* out);

/* ---- Geometry of an engine ---------------------------------------------------------------------- */

/** What is drawn, which decides the pack's program; docs/embedding.md has the table. Sky, sun, moon, stars
 *  and clouds are Orris's. Kinds are drawn in an order of their own, batches of a kind in that of
 *  submission. */
typedef enum OrrisKind {
  ORRIS_KIND_SOLID = 0,
  ORRIS_KIND_CUTOUT = 1,
  ORRIS_KIND_TRANSLUCENT = 2,  /**< water, glass: submit what is far first */
  ORRIS_KIND_BLOCK_ENTITY = 3, /**< chests, signs */
  ORRIS_KIND_BLOCK_TEXT = 4,
  ORRIS_KIND_BEAM = 5,
  ORRIS_KIND_BEAM_GLOW = 6,
  ORRIS_KIND_CRACKS = 7, /**< of a block being broken */
  ORRIS_KIND_LINES = 8,  /**< quads too, the outline of a block */
  ORRIS_KIND_LEASH = 9,  /**< whatever has colour and no texture */
  ORRIS_KIND_ENTITY = 10,
  ORRIS_KIND_ENTITY_TRANSLUCENT = 11,
  ORRIS_KIND_ENTITY_EYES = 12,
  ORRIS_KIND_GLINT = 13,
  ORRIS_KIND_LIGHTNING = 14,
  ORRIS_KIND_PARTICLE = 15,
  ORRIS_KIND_PARTICLE_TRANSLUCENT = 16,
  ORRIS_KIND_HAND = 17, /**< positions in view space; the field of view is the game's, 70 degrees */
  ORRIS_KIND_HAND_TRANSLUCENT = 18,
  ORRIS_KIND_WEATHER = 19,
  ORRIS_KIND_BORDER = 20,
  ORRIS_KIND_SHADOW_ONLY = 21, /**< the player's own body */
  ORRIS_KIND_COUNT = 22
} OrrisKind;
#define ORRIS_KIND_BIT(kind) (1u << (kind))

/** The vertex of a batch, 56 bytes. Where a vertex of the engine begins with one, or has one inside, give
 *  stride and offset. Attributes that a kind has no use for keep the values of {0}, but normal, colour,
 *  light and entity, whose neutral values stand in brackets. */
typedef struct OrrisVertex {
  float position[3];     /**< blocks, from the batch's origin. gl_Vertex, vaPosition */
  float uv[2];           /**< of the albedo texture, 0 to 1. gl_MultiTexCoord0, vaUV0 */
  float mid_uv[2];       /**< middle of the face in the texture. mc_midTexCoord */
  int8_t normal[4];      /**< -127 to 127, world axes [0, 0, 127]; the fourth is 0. gl_Normal, vaNormal */
  int8_t tangent[4];     /**< along u; the fourth is the sign of the bitangent. at_tangent */
  uint8_t color[4];      /**< tint, with ambient occlusion as orris_renderer_pack_facts() asks [255].
                              gl_Color, vaColor */
  int16_t light[2];      /**< block and sky light, level * 16, 0 to 240. gl_MultiTexCoord1 and 2, vaUV2 */
  int8_t mid_block[4];   /**< to the middle of the block, 1/64 block; the fourth is its light. at_midBlock */
  int32_t entity[2];     /**< orris_renderer_block_id() and 1 for a fluid, else -1 [-1, -1]. mc_Entity */
} OrrisVertex;

/** What of a pack changes the engine's vertices; ask again after each load, option and dimension. */
typedef struct OrrisPackFacts {
  uint32_t struct_size;
  int32_t separate_ao;     /**< 1: ambient occlusion is alpha of the colour; 0: multiplied into it, alpha 255 */
  int32_t old_lighting;    /**< 1: the colour is darkened by direction: down 0.5, north and south 0.8, east and
                                west 0.6 */
  float ambient_occlusion; /**< strength that the pack wants, 0 to 1 */
  int32_t reads_normals;   /**< some program samples `normals` (LabPBR) */
  int32_t reads_specular;
  int32_t casts_shadows;   /**< there is a shadow pass */
  uint32_t generation;     /**< another number after each load: ids may be others */
} OrrisPackFacts;
/** `facts->struct_size` must be set. */
ORRIS_API OrrisStatus orris_renderer_pack_facts(OrrisRenderer* renderer, OrrisPackFacts* facts);

/** The number that the pack's block.properties gives a block, -1 for none: for OrrisVertex.entity and
 *  OrrisBatch.block_entity. `state`: "minecraft:oak_log[axis=y]", properties as far as they matter. */
ORRIS_API OrrisStatus orris_renderer_block_id(OrrisRenderer* renderer, const char* state, int32_t* out);
/** By entity.properties: 0 where the pack has none, 65535 for what it does not list. */
ORRIS_API OrrisStatus orris_renderer_entity_id(OrrisRenderer* renderer, const char* name, int32_t* out);
/** By item.properties, -1 for none. */
ORRIS_API OrrisStatus orris_renderer_item_id(OrrisRenderer* renderer, const char* name, int32_t* out);

/** GL names of 2-D textures, sampled as their own parameters say (the game: nearest, with mipmaps). 0: white
 *  albedo; flat and rough maps. */
typedef struct OrrisTextures {
  uint32_t albedo, normals, specular;
} OrrisTextures;

typedef enum OrrisPrimitive {
  ORRIS_QUADS = 0,    /**< four vertices each; Orris has the indices */
  ORRIS_TRIANGLES = 1 /**< three vertices, or indices, each */
} OrrisPrimitive;

enum { ORRIS_PASS_CAMERA = 1, ORRIS_PASS_SHADOW = 2 };

/** Buffers to draw in the next frame. Copied; the GL objects must live until the frame is drawn. Faces are
 *  counter-clockwise from outside. Orris leaves out nothing: cull before submitting. */
typedef struct OrrisBatch {
  uint32_t struct_size;
  OrrisKind kind;
  uint32_t passes;        /**< ORRIS_PASS_CAMERA, ORRIS_PASS_SHADOW or both. Default: both */
  OrrisPrimitive primitive;
  double origin[3];       /**< where position 0 is, blocks of the world */
  OrrisTextures textures;
  uint32_t vertex_buffer; /**< GL name */
  uint32_t stride;        /**< bytes, 56 or more. Default: 56 */
  uint64_t offset;        /**< bytes to the first OrrisVertex */
  uint32_t first;         /**< vertex; with indices added to each */
  uint32_t count;         /**< vertices, or indices */
  uint32_t index_buffer;  /**< GL name; 0: none. Of triangles only */
  uint32_t index_bytes;   /**< 2 or 4. Indices are not read back: they must lie within vertex_buffer */
  uint64_t index_offset;  /**< bytes */
  int32_t entity;         /**< uniform entityId. Default: 0 */
  int32_t item;           /**< currentRenderedItemId. Default: -1 */
  int32_t block_entity;   /**< blockEntityId. Default: -1 */
  float entity_color[4];  /**< red when hurt, white when about to burst; alpha is its share */
} OrrisBatch;
/** `size` is sizeof(OrrisBatch). A NULL pointer is ignored. */
ORRIS_API void orris_batch_init(OrrisBatch* batch, size_t size);

/** To be drawn in the next frame. Errors: ORDER of a renderer with a world of Orris; ARGUMENT for names that
 *  are no GL objects, ranges beyond the end of a buffer, numbers out of their range. */
ORRIS_API OrrisStatus orris_renderer_submit(OrrisRenderer* renderer, const OrrisBatch* batch);

/** A kind being drawn from the camera or the light: the pack's program, its targets, uniforms and
 *  fixed state are bound. */
typedef struct OrrisDraw OrrisDraw;
/** Draws geometry of a kind with GL calls of the engine's own. It may bind vertex arrays, buffers, and textures
 *  beyond the units that the program reads; programs, framebuffers, viewport, depth, blending and culling it
 *  leaves as they are. Of Orris only the functions orris_draw_*() may be called in it. */
typedef void (*OrrisDrawCallback)(OrrisDraw* draw, void* user);
/** Called in every frame for every pass of the kinds, after batches that were submitted; `kinds` are bits
 *  ORRIS_KIND_BIT(), 0 or a NULL callback end it. Errors: as orris_renderer_submit(). */
ORRIS_API OrrisStatus orris_renderer_set_draw_callback(OrrisRenderer* renderer, uint32_t kinds,
                                                       OrrisDrawCallback callback, void* user);

typedef struct OrrisDrawFacts {
  uint32_t struct_size;
  OrrisKind kind;
  int32_t shadow;            /**< 1: from the light */
  int32_t patches;           /**< 1: the program has tessellation stages: draw GL_PATCHES of 3 vertices */
  uint32_t program;          /**< GL name */
  const char* program_name;  /**< "gbuffers_terrain_solid" */
  double camera_position[3]; /**< world, of the eye in both passes */
  float view[16], projection[16]; /**< of the pass: player space to view space to clip space */
} OrrisDrawFacts;
/** `facts->struct_size` must be set. Errors: HANDLE outside of the callback. */
ORRIS_API OrrisStatus orris_draw_facts(OrrisDraw* draw, OrrisDrawFacts* facts);

typedef enum OrrisAttribute {
  ORRIS_ATTRIBUTE_POSITION = 0,
  ORRIS_ATTRIBUTE_UV = 1,
  ORRIS_ATTRIBUTE_MID_UV = 2,
  ORRIS_ATTRIBUTE_NORMAL = 3,
  ORRIS_ATTRIBUTE_TANGENT = 4,
  ORRIS_ATTRIBUTE_COLOR = 5,
  ORRIS_ATTRIBUTE_LIGHT = 6,
  ORRIS_ATTRIBUTE_MID_BLOCK = 7,
  ORRIS_ATTRIBUTE_ENTITY = 8
} OrrisAttribute;
/** Location of what OrrisVertex calls so; -1 where the program does not read it. In a compatibility context
 *  old GLSL reads position, uv, normal, colour and light from GL's fixed arrays, which have no location:
 *  orris_draw_bind_vertices() sets these, too. Errors: ARGUMENT, HANDLE outside of the callback. */
ORRIS_API OrrisStatus orris_draw_attribute_location(OrrisDraw* draw, OrrisAttribute attribute,
                                                    int32_t* out);
/** Points all attributes at OrrisVertex structs in the bound GL_ARRAY_BUFFER, in the bound vertex array. */
ORRIS_API OrrisStatus orris_draw_bind_vertices(OrrisDraw* draw, uint32_t stride, uint64_t offset);
/** Origin, textures, ids and entity colour of what is drawn next, as in OrrisBatch, whose other fields it does
 *  not read. Before the first call: origin at the eye, no textures, no ids. */
ORRIS_API OrrisStatus orris_draw_set(OrrisDraw* draw, const OrrisBatch* values);

/* ---- GL objects, for programs without GL of their own ------------------------------------------- */

/** A buffer with these bytes; `data` NULL: zeros. Errors: ARGUMENT for 0 bytes, CONTEXT, MEMORY. */
ORRIS_API OrrisStatus orris_buffer_create(OrrisContext* context, const void* data, size_t bytes,
                                          uint32_t* out);
ORRIS_API OrrisStatus orris_buffer_destroy(OrrisContext* context, uint32_t buffer);
/** A texture of RGBA, 8 bits each, top row first at v = 0; nearest texels, `levels` mipmaps (1: none),
 *  repeated. Errors: ARGUMENT for sizes beyond the driver's, CONTEXT. */
ORRIS_API OrrisStatus orris_texture_create(OrrisContext* context, int32_t width, int32_t height,
                                           const void* rgba, int32_t levels, uint32_t* out);
ORRIS_API OrrisStatus orris_texture_destroy(OrrisContext* context, uint32_t texture);

#ifdef __cplusplus
}
#endif
#endif
