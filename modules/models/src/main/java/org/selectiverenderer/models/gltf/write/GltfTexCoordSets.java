package org.selectiverenderer.models.gltf.write;

import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.x3d.catalogue.NodeView;
import org.selectiverenderer.x3d.tessellate.TextureCoordinateSource;

/**
 * The texture coordinates of a mesh: which {@code TEXCOORD_n} a texture's mapping selects (X3D 4.0,
 * 12.4.5 and 18.4.4). glTF has coordinates of two dimensions only, and generates none.
 *
 * @param channels the texture coordinates in the order of the geometry; none for a mesh without
 */
record GltfTexCoordSets(List<Channel> channels) {
  /** The number of coordinates that glTF cannot hold. */
  static final int NONE = -1;

  /**
   * The coordinates of one name.
   *
   * @param mapping the name by which textures refer to them, or ""
   * @param number n of {@code TEXCOORD_n}, or {@link #NONE}
   * @param source 0 for the first coordinates of the mesh, n for the n-th further ones
   */
  record Channel(String mapping, int number, int source) {}

  static GltfTexCoordSets of(NodeView geometry, Mesh mesh) {
    List<Channel> channels = new ArrayList<>();
    int number = 0;
    for (TextureCoordinateSource source : TextureCoordinateSource.of(geometry)) {
      boolean plane =
          source.set() == 0
              ? mesh.texCoords() != null
              : source.set() > 0
                  && source.set() <= mesh.moreTexCoords().size()
                  && mesh.moreTexCoords().get(source.set() - 1).components() == 2;
      channels.add(new Channel(source.mapping(), plane ? number++ : NONE, source.set()));
    }
    if (channels.isEmpty() && mesh.texCoords() != null) {
      channels.add(new Channel("", 0, 0));
    }
    return new GltfTexCoordSets(List.copyOf(channels));
  }

  boolean isEmpty() {
    return channels.isEmpty();
  }

  /** Returns n of the {@code TEXCOORD_n} that a mapping selects, or {@link #NONE}. */
  int number(String mapping) {
    return channels.stream()
        .filter(channel -> channel.mapping().equals(mapping) && !mapping.isEmpty())
        .findFirst()
        .or(() -> channels.stream().findFirst())
        .map(Channel::number)
        .orElse(NONE);
  }
}
