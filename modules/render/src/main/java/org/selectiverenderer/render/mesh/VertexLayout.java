package org.selectiverenderer.render.mesh;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.geometry.mesh.Mesh;

/**
 * The layout of a vertex in the vertex buffer: the byte offset of each attribute, -1 for one that
 * the mesh does not have. The position comes first: three floats.
 *
 * @param stride bytes per vertex
 * @param normal four signed normalised shorts, the last unused: ten bits would show in highlights
 * @param color four unsigned normalised bytes r, g, b, a
 * @param texCoord two floats
 * @param more the number of floats of each further texture coordinate, at the end of the vertex
 */
public record VertexLayout(int stride, int normal, int color, int texCoord, List<Integer> more) {
  private static final int POSITION_BYTES = 12;

  /** Returns the layout of a mesh's attributes. */
  public static VertexLayout of(Mesh mesh) {
    int stride = POSITION_BYTES;
    int normal = -1;
    int color = -1;
    int texCoord = -1;
    if (mesh.normals() != null) {
      normal = stride;
      stride += 8;
    }
    if (mesh.colors() != null) {
      color = stride;
      stride += 4;
    }
    if (mesh.hasTexCoords()) {
      texCoord = stride;
      stride += 8;
    }
    List<Integer> more =
        mesh.moreTexCoords().isEmpty()
            ? List.of()
            : mesh.moreTexCoords().stream().map(Mesh.TexCoords::components).toList();
    for (int size : more) {
      stride += 4 * size;
    }
    return new VertexLayout(stride, normal, color, texCoord, more);
  }

  // Written out, as records link theirs when first called: the first frame would wait for it.
  @Override
  public boolean equals(@Nullable Object other) {
    return other instanceof VertexLayout one
        && stride == one.stride
        && normal == one.normal
        && color == one.color
        && texCoord == one.texCoord
        && more.equals(one.more);
  }

  @Override
  public int hashCode() {
    return 31 * (31 * (31 * (31 * stride + normal) + color) + texCoord) + more.hashCode();
  }
}
