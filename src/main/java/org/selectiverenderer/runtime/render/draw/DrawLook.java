package org.selectiverenderer.runtime.render.draw;

import java.nio.FloatBuffer;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.runtime.instance.LightInstance;
import org.selectiverenderer.runtime.render.gpu.GpuTexture;
import org.selectiverenderer.runtime.render.gpu.ShapePrograms;
import org.selectiverenderer.runtime.render.mesh.VertexLayout;

/**
 * All that one call of the drawing needs beside the triangles: shapes of equal looks may be drawn
 * by one call.
 *
 * @param lights those whose scope the shape lies in
 * @param material as the fragment shader wants it; compared by its numbers
 * @param textureTransform nine numbers, compared likewise
 */
record DrawLook(
    ShapePrograms.Family programs,
    @Nullable GpuTexture texture,
    List<LightInstance> lights,
    FloatBuffer material,
    FloatBuffer textureTransform,
    boolean blended,
    VertexLayout layout,
    Mesh.Primitive primitive,
    boolean solid) {}
