// Sizes and formats that follow from the options. shaders.properties repeats products of some: it knows no arithmetic.
#if !defined INCLUDED_DERIVED_SIZES
#define INCLUDED_DERIVED_SIZES

// Volumes of 96 and 128 need a shadow target of 2048, 256 (128 high) one of 4096; with a smaller one they
// fall back, in the end to 64, which is also AUTO where the host does not choose. The face cache has at
// most 128. shaders.properties says the same.
#if VOXEL_SIZE == 256 && SHADOW_RESOLUTION >= 4096 && !HAS_FACE_CACHE
#define VOLUME 256
#elif VOXEL_SIZE >= 128 && SHADOW_RESOLUTION >= 2048
#define VOLUME 128
#elif VOXEL_SIZE == 96 && SHADOW_RESOLUTION >= 2048
#define VOLUME 96
#elif VOXEL_SIZE == 32 || VOXEL_SIZE == 48
#define VOLUME VOXEL_SIZE
#else
#define VOLUME 64
#endif
#if VOLUME == 256
#define VOLUME_HEIGHT 128
#else
#define VOLUME_HEIGHT VOLUME
#endif

// Tiles of the atlas (include/voxels/volume.glsl); ATLAS_SIZE in shaders.properties is their number times VOLUME.
#if VOLUME == 32
#define ATLAS_COLUMNS 32
#define ATLAS_ROWS 1
#elif VOLUME == 48
#define ATLAS_COLUMNS 16
#define ATLAS_ROWS 3
#elif VOLUME == 96
#define ATLAS_COLUMNS 20
#define ATLAS_ROWS 5
#elif VOLUME >= 128
#define ATLAS_COLUMNS 16
#define ATLAS_ROWS 8
#else
#define ATLAS_COLUMNS 16
#define ATLAS_ROWS 4
#endif

#if FLOODFILL_RULE == FLOODFILL_RULE_CONSERVING
#define FLOODFILL_FORMAT rgba32f
#define FLOODFILL_IMAGE image3D
#else
#define FLOODFILL_FORMAT rg32ui
#define FLOODFILL_IMAGE uimage3D
#endif

#if LIGHT_METHOD == LIGHT_METHOD_TILED
#define LIGHT_GRID_SLICES 1
#else
#define LIGHT_GRID_SLICES LIGHT_SLICES
#endif

// Tiles about as high as wide on a screen of 16 to 9; LIGHT_TILES in shaders.properties is LIGHT_COLUMNS * LIGHT_ROWS.
#if LIGHT_COLUMNS == 8
#define LIGHT_ROWS 5
#elif LIGHT_COLUMNS == 16
#define LIGHT_ROWS 9
#elif LIGHT_COLUMNS == 32
#define LIGHT_ROWS 18
#else
#define LIGHT_ROWS 12
#endif

// Side of the shadow targets: the voxels need 1024 texels in a row.
#if HAS_VOXELS && SHADOW_RESOLUTION < 1024
#define SHADOW_TARGET 1024
#else
#define SHADOW_TARGET SHADOW_RESOLUTION
#endif

const int shadowMapResolution = SHADOW_TARGET;
const float shadowDistance = SHADOW_DISTANCE;
const float shadowDistanceRenderMul = 1.0;

#endif
