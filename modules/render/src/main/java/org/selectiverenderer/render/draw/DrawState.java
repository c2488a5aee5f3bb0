package org.selectiverenderer.render.draw;

import java.util.Arrays;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.instance.DrawProperties;
import org.selectiverenderer.browser.instance.LightInstance;
import org.selectiverenderer.browser.instance.ScopedEffects;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.render.gpu.GpuTexture;
import org.selectiverenderer.render.gpu.MaterialBinding;
import org.selectiverenderer.render.gpu.ShapeProgramCache;
import org.selectiverenderer.render.mesh.VertexLayout;

/**
 * The state that a draw call needs besides its triangles. Shapes of equal draw state that are lit
 * alike may be drawn by one call.
 *
 * @param byPixel the shader programs with per-pixel lighting
 * @param byVertex the shader programs with per-vertex lighting
 * @param reaching the lights that reach the shape
 * @param material the material's twelve uniform values, in the order of the lighting shader
 * @param textureTransform a 3 x 3 matrix
 * @param around the fog, clip planes and environment light in whose scope the shape is
 * @param detail the textures and uniforms of a surface that has more than that, else null
 * @param author the custom shader, else null
 */
record DrawState(
    ShapeProgramCache.Family byPixel,
    ShapeProgramCache.Family byVertex,
    @Nullable GpuTexture texture,
    List<LightInstance> reaching,
    FloatArrayKey material,
    FloatArrayKey textureTransform,
    boolean blended,
    VertexLayout layout,
    DrawProperties stroke,
    ScopedEffects around,
    Mesh.Primitive primitive,
    boolean solid,
    @Nullable MaterialBinding detail,
    @Nullable CustomShaderBinding author) {

  /** Returns the same state with other programs. */
  DrawState drawnBy(ShapeProgramCache.Family pixel, ShapeProgramCache.Family vertex) {
    return with(pixel, vertex, material);
  }

  /** Returns the same state with another material. */
  DrawState of(FloatArrayKey other) {
    return with(byPixel, byVertex, other);
  }

  private DrawState with(
      ShapeProgramCache.Family pixel, ShapeProgramCache.Family vertex, FloatArrayKey other) {
    return new DrawState(
        pixel,
        vertex,
        texture,
        reaching,
        other,
        textureTransform,
        blended,
        layout,
        stroke,
        around,
        primitive,
        solid,
        detail,
        author);
  }

  // Written out, as records link theirs when first called: the first frame would wait for it.
  @Override
  public boolean equals(@Nullable Object other) {
    return other instanceof DrawState one && parts().equals(one.parts());
  }

  @Override
  public int hashCode() {
    return parts().hashCode();
  }

  private List<@Nullable Object> parts() {
    return Arrays.asList(
        byPixel,
        byVertex,
        texture,
        reaching,
        material,
        textureTransform,
        blended,
        layout,
        stroke,
        around,
        primitive,
        solid,
        detail,
        author);
  }
}
