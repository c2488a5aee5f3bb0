package org.selectiverenderer.browser.instance;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.nodes.shape.GeneratedCubeMapTextureNode;
import org.selectiverenderer.browser.scene.Node;

/** Reads texture nodes that are not MultiTextures (X3D 4.0, 18.4, 33.4, 34.4). */
final class TextureReader {
  /** The fields of a ComposedCubeMapTexture in the order of {@link CubeTexture}. */
  private static final List<String> FACES =
      List.of(
          "frontTexture",
          "backTexture",
          "leftTexture",
          "rightTexture",
          "topTexture",
          "bottomTexture");

  private TextureReader() {}

  /**
   * Reads a texture node; empty for null, for a texture without an image and for an unknown node
   * type.
   */
  static Optional<TextureSource> read(@Nullable Node node, AssetProvider assets) {
    if (node == null) {
      return Optional.empty();
    }
    return switch (node.type().name()) {
      case "ImageTexture", "PixelTexture", "MovieTexture" ->
          assets
              .image(node)
              .map(
                  image ->
                      new Texture(
                          image,
                          node.bool("repeatS"),
                          node.bool("repeatT"),
                          TextureSamplerReader.of(node)));
      case "ComposedCubeMapTexture" -> composedCube(node, assets);
      case "ImageCubeMapTexture" ->
          assets
              .image(node)
              .filter(image -> image.layers() == CubeTexture.FACES)
              .map(image -> cube(image, TextureSamplerReader.of(node)));
      case "GeneratedCubeMapTexture" ->
          node instanceof GeneratedCubeMapTextureNode cube
              ? Optional.of(GeneratedCubeTexture.of(cube))
              : Optional.empty();
      case "PixelTexture3D", "ImageTexture3D" ->
          assets.image(node).map(image -> volume(image, node));
      case "ComposedTexture3D" -> composedVolume(node, assets);
      default -> Optional.empty();
    };
  }

  private static TextureSource cube(Texture.Image image, @Nullable TextureSampler sampling) {
    List<CubeTexture.Face> faces = new ArrayList<>();
    for (int i = 0; i < CubeTexture.FACES; i++) {
      faces.add(new CubeTexture.Face(image, i));
    }
    return new CubeTexture(List.copyOf(faces), sampling);
  }

  private static Optional<TextureSource> composedCube(Node node, AssetProvider assets) {
    List<CubeTexture.Face> faces = new ArrayList<>();
    for (String field : FACES) {
      Node face = node.node(field);
      if (face != null) {
        assets.image(face).ifPresent(image -> faces.add(new CubeTexture.Face(image, 0)));
      }
    }
    return faces.size() == CubeTexture.FACES
        ? Optional.of(new CubeTexture(List.copyOf(faces), TextureSamplerReader.of(node)))
        : Optional.empty();
  }

  private static TextureSource volume(Texture.Image image, Node node) {
    return new VolumeTexture(
        image,
        node.bool("repeatS"),
        node.bool("repeatT"),
        node.bool("repeatR"),
        TextureSamplerReader.of(node));
  }

  /**
   * Reads a ComposedTexture3D: its slices are the images of its textures; those of another size
   * than the first are left out.
   */
  private static Optional<TextureSource> composedVolume(Node node, AssetProvider assets) {
    List<Texture.Image> slices = new ArrayList<>();
    for (Node texture : node.nodes("texture")) {
      assets
          .image(texture)
          .filter(
              image ->
                  slices.isEmpty()
                      || image.width() == slices.get(0).width()
                          && image.height() == slices.get(0).height())
          .ifPresent(slices::add);
    }
    if (slices.isEmpty()) {
      return Optional.empty();
    }
    Texture.Image first = slices.get(0);
    int size = first.width() * first.height() * 4;
    byte[] rgba = new byte[size * slices.size()];
    for (int i = 0; i < slices.size(); i++) {
      System.arraycopy(slices.get(i).rgba(), 0, rgba, i * size, size);
    }
    return Optional.of(
        volume(
            new Texture.Image(
                first.width(), first.height(), slices.size(), first.components(), rgba),
            node));
  }
}
