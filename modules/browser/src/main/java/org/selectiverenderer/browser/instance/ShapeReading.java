package org.selectiverenderer.browser.instance;

import java.util.List;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.nodes.shape.GeneratedCubeMapTextureNode;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.ProceduralShape;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.x3d.tessellate.GeoMeshOrigin;

/**
 * The mesh, material and drawing properties that the present fields of a Shape and of the nodes in
 * it stand for. Shapes of the same template, copies of one in an inlined file, may share it.
 *
 * @param anchor the origin of the mesh's coordinates in the Shape's coordinates; null if they are
 *     the same
 * @param onScreen whether the geometry is text measured in pixels (X3D 4.0, 36.4.4)
 */
record ShapeReading(
    @Nullable Mesh mesh,
    @Nullable Vector3dc anchor,
    SurfaceMaterial surface,
    DrawProperties stroke,
    List<ShaderProgramSource> programs,
    List<GeneratedCubeMapTextureNode> cubes,
    boolean onScreen) {

  static ShapeReading of(Node shape, @Nullable Node geometry, AssetProvider assets) {
    Node appearance = shape.node("appearance");
    DrawProperties stroke = DrawPropertiesReader.read(appearance);
    Mesh formed;
    Vector3dc anchor = null;
    if (shape instanceof ProceduralShape own) {
      formed = own.form().orElse(null);
    } else {
      formed = geometry == null ? null : assets.mesh(geometry).orElse(null);
      anchor = geometry == null ? null : GeoMeshOrigin.of(geometry).orElse(null);
    }
    SurfaceMaterial surface = AppearanceReader.read(appearance, geometry, assets);
    List<ShaderProgramSource> programs = ShaderProgramReader.read(appearance, geometry, assets);
    return new ShapeReading(
        LineTextureCoordinates.of(formed, stroke),
        anchor,
        surface,
        stroke,
        programs,
        GeneratedCubeTexture.in(surface, programs),
        isOnScreen(geometry));
  }

  private static boolean isOnScreen(@Nullable Node geometry) {
    if (geometry == null || !geometry.type().name().equals("Text")) {
      return false;
    }
    Node style = geometry.node("fontStyle");
    return style != null && style.type().name().equals("ScreenFontStyle");
  }
}
