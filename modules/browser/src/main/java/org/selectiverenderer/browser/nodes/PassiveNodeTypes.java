package org.selectiverenderer.browser.nodes;

import java.util.Set;

/**
 * The names of supported node types without a behaviour of their own: nodes that others read as
 * geometry, appearance, light or description.
 */
final class PassiveNodeTypes {
  private static final Set<String> SHAPES =
      Set.of(
          "Shape",
          "Appearance",
          "Material",
          "UnlitMaterial",
          "PhysicalMaterial",
          "TwoSidedMaterial",
          "LineProperties",
          "ShaderPart",
          "PointProperties",
          "FillProperties",
          "ImageTexture",
          "PixelTexture",
          "TextureTransform");

  private static final Set<String> TEXTURES =
      Set.of(
          "ComposedCubeMapTexture",
          "ComposedTexture3D",
          "ImageCubeMapTexture",
          "ImageTexture3D",
          "MultiTexture",
          "MultiTextureTransform",
          "PixelTexture3D",
          "TextureProperties",
          "TextureTransform3D",
          "TextureTransformMatrix3D");

  private static final Set<String> GEOMETRY =
      Set.of(
          "Arc2D",
          "ArcClose2D",
          "Box",
          "Circle2D",
          "Cone",
          "Cylinder",
          "Disk2D",
          "ElevationGrid",
          "Extrusion",
          "GeoElevationGrid",
          "IndexedFaceSet",
          "IndexedLineSet",
          "IndexedQuadSet",
          "IndexedTriangleFanSet",
          "IndexedTriangleSet",
          "IndexedTriangleStripSet",
          "LineSet",
          "NurbsCurve",
          "NurbsPatchSurface",
          "NurbsSweptSurface",
          "NurbsSwungSurface",
          "NurbsTrimmedSurface",
          "PointSet",
          "Polyline2D",
          "Polypoint2D",
          "QuadSet",
          "Rectangle2D",
          "Sphere",
          "Text",
          "TriangleFanSet",
          "TriangleSet",
          "TriangleSet2D",
          "TriangleStripSet");

  private static final Set<String> GEOMETRY_DATA =
      Set.of(
          "Color",
          "ColorRGBA",
          "Coordinate",
          "CoordinateDouble",
          "FontStyle",
          "GeoCoordinate",
          "GeoOrigin",
          "HAnimDisplacer",
          "FloatVertexAttribute",
          "FogCoordinate",
          "Matrix3VertexAttribute",
          "Matrix4VertexAttribute",
          "Contour2D",
          "ContourPolyline2D",
          "Normal",
          "MultiTextureCoordinate",
          "NurbsCurve2D",
          "NurbsTextureCoordinate",
          "ScreenFontStyle",
          "Tangent",
          "TextureCoordinate",
          "TextureCoordinate3D",
          "TextureCoordinate4D",
          "TextureCoordinateGenerator");

  private static final Set<String> PARTICLES =
      Set.of(
          "BoundedPhysicsModel",
          "ConeEmitter",
          "ExplosionEmitter",
          "ForcePhysicsModel",
          "PointEmitter",
          "PolylineEmitter",
          "SurfaceEmitter",
          "VolumeEmitter",
          "WindPhysicsModel");

  private static final Set<String> LIGHTS =
      Set.of("DirectionalLight", "EnvironmentLight", "PointLight", "SpotLight");

  private static final Set<String> EFFECTS = Set.of("LocalFog", "ClipPlane", "LayerSet", "Layout");

  private static final Set<String> DESCRIPTIONS =
      Set.of(
          "GeoMetadata",
          "MetadataBoolean",
          "MetadataDouble",
          "MetadataFloat",
          "MetadataInteger",
          "MetadataSet",
          "MetadataString",
          "WorldInfo");

  private PassiveNodeTypes() {}

  static boolean isRead(String typeName) {
    return SHAPES.contains(typeName)
        || TEXTURES.contains(typeName)
        || GEOMETRY.contains(typeName)
        || GEOMETRY_DATA.contains(typeName)
        || PARTICLES.contains(typeName)
        || LIGHTS.contains(typeName)
        || EFFECTS.contains(typeName)
        || DESCRIPTIONS.contains(typeName);
  }
}
