package org.selectiverenderer.models.gltf.write;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.catalogue.NodeView;
import org.selectiverenderer.x3d.url.IoErrorFormatter;
import org.selectiverenderer.x3d.url.ResolvedUrlContent;
import org.selectiverenderer.x3d.url.UrlContent;
import org.selectiverenderer.x3d.url.UrlResolver;

/** Writes textures with their images; each image is embedded once. */
final class GltfTextureWriter {
  private static final int MAX_IMAGE_BYTES = 64 << 20;
  private static final int REPEAT = 10497;
  private static final int CLAMP_TO_EDGE = 33071;
  private static final int MIRRORED_REPEAT = 33648;
  private static final int NEAREST = 9728;
  private static final int LINEAR = 9729;

  /**
   * A texture of the document.
   *
   * @param index its index
   * @param image what it shows
   */
  record Texture(int index, GltfImage image) {}

  /** An image of the document, by its index. */
  private record Embedded(int index, GltfImage image) {}

  private final GltfDocument out;
  private final UrlResolver root;
  private final PngTranscoder transcoder;
  private final GltfLosses losses;
  private final Map<NodeView, Optional<Texture>> textures = new HashMap<>();
  private final Map<String, Optional<Embedded>> images = new HashMap<>();
  private final Map<Sampler, Integer> samplers = new HashMap<>();

  /** A sampler in the numbers of GL; a filter of 0 is left to the reader. */
  private record Sampler(int wrapS, int wrapT, int magnification, int minification) {}

  GltfTextureWriter(
      GltfDocument out, UrlResolver root, PngTranscoder transcoder, GltfLosses losses) {
    this.out = out;
    this.root = root;
    this.transcoder = transcoder;
    this.losses = losses;
  }

  /** Returns the texture of a texture node; empty if glTF cannot hold it, which is reported. */
  Optional<Texture> texture(@Nullable NodeView node, GltfPlace place) throws IOException {
    if (node == null) {
      return Optional.empty();
    }
    Optional<Texture> known = textures.get(node);
    if (known == null) {
      known = read(node, place);
      textures.put(node, known);
    }
    return known;
  }

  private Optional<Texture> read(NodeView node, GltfPlace place) throws IOException {
    Optional<Embedded> image;
    switch (node.type().name()) {
      case "ImageTexture" -> image = ofUrl(node, place);
      case "PixelTexture" -> image = embedded(GltfImage.ofPixels(node.ints("image")));
      case "MultiTexture" -> {
        losses.tell(
            "MultiTexture",
            node.location(),
            "glTF mixes no textures; of a MultiTexture the first one is written");
        return node.nodes("texture").isEmpty()
            ? Optional.empty()
            : texture(node.nodes("texture").get(0), place);
      }
      default -> {
        losses.node(node);
        return Optional.empty();
      }
    }
    if (image.isEmpty()) {
      return Optional.empty();
    }
    ObjectNode texture = out.object().put("sampler", sampler(node));
    texture.put("source", image.get().index());
    if (node.name() != null) {
      texture.put("name", node.name());
    }
    return Optional.of(new Texture(out.add("textures", texture), image.get().image()));
  }

  private Optional<Embedded> ofUrl(NodeView node, GltfPlace place) throws IOException {
    ResolvedUrlContent choice =
        ResolvedUrlContent.of(node, root, place.base(node), "the texture is left out");
    if (!(choice instanceof ResolvedUrlContent.Found found)) {
      losses.problems().add(((ResolvedUrlContent.None) choice).problem());
      return Optional.empty();
    }
    UrlContent content = found.content();
    Optional<Embedded> known = images.get(content.key());
    if (known == null) {
      known = embedded(image(node, content));
      images.put(content.key(), known);
    }
    return known;
  }

  private Optional<GltfImage> image(NodeView node, UrlContent content) {
    try {
      Optional<GltfImage> image = GltfImage.of(content.bytes(MAX_IMAGE_BYTES));
      return image.isPresent() ? image : GltfImage.of(transcoder.png(content));
    } catch (IOException e) {
      losses
          .problems()
          .error(
              node.location(),
              "%s %s; the texture is left out"
                  .formatted(content.name(), IoErrorFormatter.clause(e)));
      return Optional.empty();
    }
  }

  private Optional<Embedded> embedded(Optional<GltfImage> image) throws IOException {
    if (image.isEmpty()) {
      return Optional.empty();
    }
    ObjectNode entry =
        out.object()
            .put("bufferView", out.bytes(image.get().bytes()))
            .put("mimeType", image.get().mimeType());
    return Optional.of(new Embedded(out.add("images", entry), image.get()));
  }

  private int sampler(NodeView texture) {
    int wrapS = texture.bool("repeatS") ? REPEAT : CLAMP_TO_EDGE;
    int wrapT = texture.bool("repeatT") ? REPEAT : CLAMP_TO_EDGE;
    NodeView properties = texture.node("textureProperties");
    if (properties == null) {
      return sampler(new Sampler(wrapS, wrapT, 0, 0));
    }
    return sampler(
        new Sampler(
            wrap(properties.string("boundaryModeS"), wrapS),
            wrap(properties.string("boundaryModeT"), wrapT),
            magnification(properties.string("magnificationFilter")),
            minification(properties.string("minificationFilter"))));
  }

  private int sampler(Sampler wanted) {
    Integer known = samplers.get(wanted);
    if (known != null) {
      return known;
    }
    ObjectNode entry = out.object().put("wrapS", wanted.wrapS).put("wrapT", wanted.wrapT);
    if (wanted.magnification > 0) {
      entry.put("magFilter", wanted.magnification);
    }
    if (wanted.minification > 0) {
      entry.put("minFilter", wanted.minification);
    }
    int added = out.add("samplers", entry);
    samplers.put(wanted, added);
    return added;
  }

  private static int wrap(String mode, int repeated) {
    return switch (mode) {
      case "REPEAT" -> REPEAT;
      case "MIRRORED_REPEAT" -> MIRRORED_REPEAT;
      case "CLAMP", "CLAMP_TO_EDGE", "CLAMP_TO_BOUNDARY" -> CLAMP_TO_EDGE;
      default -> repeated;
    };
  }

  private static int magnification(String filter) {
    return switch (filter) {
      case "NEAREST_PIXEL" -> NEAREST;
      case "AVG_PIXEL" -> LINEAR;
      default -> 0;
    };
  }

  private static int minification(String filter) {
    return switch (filter) {
      case "NEAREST_PIXEL" -> NEAREST;
      case "AVG_PIXEL" -> LINEAR;
      case "NEAREST_PIXEL_NEAREST_MIPMAP" -> 9984;
      case "AVG_PIXEL_NEAREST_MIPMAP" -> 9985;
      case "NEAREST_PIXEL_AVG_MIPMAP" -> 9986;
      case "AVG_PIXEL_AVG_MIPMAP" -> 9987;
      default -> 0;
    };
  }
}
