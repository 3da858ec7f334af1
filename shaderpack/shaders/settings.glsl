// Every option of the pack, and nothing else. The comment list of a line is syntax: host and game read it. What the
// words mean is in include/derived/words.glsl; what follows from the options in features.glsl (flags, HAS_) and
// sizes.glsl there.
#if !defined INCLUDED_SETTINGS
#define INCLUDED_SETTINGS

#include "/include/derived/words.glsl"

// Direct light
#define DIRECT_LIGHT PHONG // [NONE PHONG PHONG_PUBLISHED LAMBERT_GGX]
#define SUN_STRENGTH 8.0 // [0.0 2.0 4.0 6.0 8.0 12.0 16.0]
#define SKY_STRENGTH 1.0 // [0.0 0.25 0.5 1.0 1.5 2.0]
#define EMISSION_STRENGTH 16.0 // [2.0 4.0 8.0 16.0 32.0 64.0]
#define AMBIENT_MINIMUM 0.002 // [0.0 0.002 0.005 0.01 0.02 0.1]
const float sunPathRotation = -30.0; // [-60.0 -45.0 -30.0 -15.0 0.0 15.0 30.0 45.0 60.0]

// Shadows
#define SHADOW_METHOD MAP_PCF // [NONE MAP MAP_PCF VOLUME_ZPASS VOLUME_ZFAIL VOLUME_AUTO AUTO]
#define SHADOW_BIAS NORMAL_OFFSET // [PUBLISHED NORMAL_OFFSET]
#define SHADOW_COMPARE TEXEL // [TEXEL HARDWARE]
#define SHADOW_SNAP // Keep the texels of the map in place in the world
#define SHADOW_DISTORTION 0.0 // [0.0 0.5 0.7 0.85]
#define SHADOW_RESOLUTION 1024 // [256 512 1024 2048 4096]
//#define SHADOW_VIEW // Show where the sun arrives, and nothing else
#define SHADOW_DISTANCE 64.0 // [32.0 48.0 64.0 96.0 128.0]

// Global illumination
#define GI_METHOD FACE_CACHE // [NONE BOUNCE_1 BOUNCE_2 BOUNCE_4 FLOODFILL FACE_CACHE]
#define GI_SAMPLES 1 // [1 2 4 8 16 32 64 128]
#define GI_LAMPS AUTO // [HIT SAMPLED AUTO]
#define GI_TRANSLUCENT AUTO // [CACHED RAYS AUTO]
//#define GI_GLOSSY // Polished blocks and metals mirror the voxels about them
#define VOXEL_SIZE AUTO // [32 48 64 96 128 256 AUTO]
#define RAY_WALK DISTANCE // [GRID DISTANCE]
#define VOXEL_VIEW NONE // [NONE BLOCKS RADIANCE]
#define VOXEL_VIEW_FROM 0.0 // [0.0 2.0 4.0 8.0 12.0 16.0 24.0]

//#define GI_COUNTERS // Count voxels written and rays sent

// Many lamps
#define LIGHT_METHOD NONE // [NONE FORWARD DEFERRED TILED CLUSTERED AUTO]
#define LIGHT_RANGE 1.0 // [0.25 0.5 0.75 1.0 1.5]
#define LIGHT_DISTANCE 64 // [32 48 64]
#define LIGHT_SHADOWS 0 // [0 1 2 4 8] Lamps that a point sees or not: the strongest; others shine through walls
#define LIGHT_VOLUMES 0 // [0 1 2 4 8] Lamps near the eye whose shadows are volumes, exact to the pixel
//#define LIGHT_GLOSS // Lamps are reflected as the sun is (DIRECT_LIGHT), with highlights; else as by a diffuse surface
#define LIGHT_CAPACITY 16384 // [256 1024 4096 16384]
#define LIGHT_LIST 512 // [64 128 256 512 1024 2048]
#define LIGHT_COLUMNS 16 // [8 16 20 32]
#define LIGHT_SLICES 24 // [1 8 16 24 32]
#define LIGHT_SLICING LOGARITHMIC // [LINEAR LOGARITHMIC]
#define LIGHT_FIRST_SLICE 4.0 // [1.0 2.0 4.0 5.0]
#define LIGHT_DEBUG NONE // [NONE SLICE COUNT HEAT]

// Floodfill
#define FLOODFILL_STORAGE IMAGE_3D // [ATLAS_2D IMAGE_3D]
#define FLOODFILL_RULE PUBLISHED // [PUBLISHED CONSERVING]
#define FLOODFILL_SKY NONE // [NONE PUBLISHED]
#define FLOODFILL_ALPHA 2.43902 // [0.5 0.9 1.0 2.0 2.2 2.35 2.43902 2.5 2.55 2.65 2.67 2.75]
#define FLOODFILL_GAMMA 2.2 // [1.0 1.8 2.0 2.2 2.4]
#define FLOODFILL_INTERVAL 3 // [1 2 3 4 6]
#define FLOODFILL_LOOKUP PUBLISHED // [PUBLISHED SOLID_AWARE]
#define FLOODFILL_STRENGTH 1.0 // [0.25 0.5 1.0 2.0 4.0 8.0]

// Face cache
#define FACE_SHARE 4 // [1 2 4 8]
#define FACE_RAYS 1 // [1 2 4 8 16]
#define FACE_WINDOW 128 // [16 32 64 128 256]
#define FACE_GAIN 8.0 // [1.0 4.0 8.0 16.0]
#define FACE_NEAR 0.35 // [0.0 0.25 0.35 0.5 1.0]

// Noise
#define GI_FILTER // Smooth the gathered light within each face
#define TEMPORAL_ACCUMULATION // Reuse the samples of earlier frames
#define TEMPORAL_WEIGHT 0.1 // [0.02 0.05 0.1 0.2 0.5]
#define TEMPORAL_FRAMES 1024 // [10 16 32 64 128 256 1024]

// Picture
#define WATER_WAVES // Waves on open water, and the sun that they mirror
#define AUTO_EXPOSURE // Follows how bright the picture is, as eyes do
#define TONE_MAP ACES // [NONE REINHARD ACES]
#define EXPOSURE 1.0 // [0.25 0.5 0.7 1.0 1.4 2.0 4.0]

#include "/include/derived/features.glsl"
#include "/include/derived/sizes.glsl"

#endif
