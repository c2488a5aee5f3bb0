package org.selectiverenderer.models.gltf;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.Base64;
import java.util.HashMap;
import java.util.Map;
import org.selectiverenderer.models.scene.DefNames;
import org.selectiverenderer.models.scene.PictureType;
import org.selectiverenderer.x3d.write.X3dWriter;

/** Writes glTF's textures as ImageTextures: pictures inside of the file as data urls. */
final class GltfTextures {
  private static final int NEAREST = 9728;
  private static final int CLAMP_TO_EDGE = 33071;
  private static final int MIRRORED_REPEAT = 33648;

  private final GltfFile file;
  private final X3dWriter out;
  private final DefNames names;
  private final GltfProblems problems;
  private final Map<Look, String> written = new HashMap<>();

  /** An ImageTexture shows this picture in this way; glTF may have several textures of it. */
  private record Look(int image, int wrapS, int wrapT, int magFilter, int minFilter) {}

  GltfTextures(GltfTranslation shared) {
    file = shared.file();
    out = shared.out();
    names = shared.names();
    problems = shared.problems();
  }

  /**
   * Writes a texture, and one like another that has been written as a USE, so that a picture is not
   * repeated.
   *
   * @param path the path of the textureInfo, for problems
   * @param container the field that contains it
   * @return whether it can be read
   */
  boolean write(int texture, String path, String container) {
    JsonNode part = file.part("textures", texture);
    int image = source(part);
    JsonNode sampler = file.referred(part, "sampler", "samplers");
    int wrapS = sampler.path("wrapS").asInt();
    int wrapT = sampler.path("wrapT").asInt();
    Look look =
        new Look(
            image,
            wrapS,
            wrapT,
            sampler.path("magFilter").asInt(),
            sampler.path("minFilter").asInt());
    String known = written.get(look);
    if (known != null) {
      out.empty("ImageTexture", "USE", known, "containerField", container);
      return true;
    }
    String url = url(image, path);
    if (url.isEmpty()) {
      return false;
    }
    String name = part.path("name").asText(file.part("images", image).path("name").asText(""));
    String def = names.unique(name, "texture" + texture);
    written.put(look, def);
    out.open("ImageTexture", "DEF", def, "containerField", container);
    if (wrapS == CLAMP_TO_EDGE) {
      out.attribute("repeatS", "false");
    }
    if (wrapT == CLAMP_TO_EDGE) {
      out.attribute("repeatT", "false");
    }
    out.attribute("url", '"' + url + '"');
    properties(sampler, wrapS, wrapT);
    out.close();
    return true;
  }

  private static int source(JsonNode texture) {
    JsonNode webp = texture.path("extensions").path("EXT_texture_webp");
    return texture.has("source")
        ? GltfFile.index(texture, "source")
        : GltfFile.index(webp, "source");
  }

  private String url(int image, String path) {
    JsonNode part = file.part("images", image);
    if (part.isMissingNode()) {
      problems.tell(
          path, "the texture has no picture in PNG or JPEG, so the surface has none here");
      return "";
    }
    String uri = GltfFile.text(part, "uri");
    if (!uri.isEmpty()) {
      return uri.replace("\\", "%5C").replace("\"", "%22");
    }
    try {
      ByteBuffer bytes = file.view(GltfFile.index(part, "bufferView"));
      byte[] picture = new byte[bytes.remaining()];
      bytes.get(picture);
      String type = PictureType.of(picture);
      return "data:"
          + (type.isEmpty() ? "image/png" : type)
          + ";base64,"
          + Base64.getEncoder().encodeToString(picture);
    } catch (IOException e) {
      problems.tell("images[%d]".formatted(image), e.getMessage() + "; the picture is left out");
      return "";
    }
  }

  private void properties(JsonNode sampler, int wrapS, int wrapT) {
    boolean nearest = sampler.path("magFilter").asInt() == NEAREST;
    int minified = sampler.path("minFilter").asInt();
    boolean mirrored = wrapS == MIRRORED_REPEAT || wrapT == MIRRORED_REPEAT;
    if (!nearest && minified == 0 && !mirrored) {
      return;
    }
    String minification =
        switch (minified) {
          case NEAREST -> "NEAREST_PIXEL";
          case 9729 -> "AVG_PIXEL";
          case 9984 -> "NEAREST_PIXEL_NEAREST_MIPMAP";
          case 9985 -> "AVG_PIXEL_NEAREST_MIPMAP";
          case 9986 -> "NEAREST_PIXEL_AVG_MIPMAP";
          default -> "AVG_PIXEL_AVG_MIPMAP";
        };
    boolean mipmaps = minification.endsWith("MIPMAP");
    out.empty(
        "TextureProperties",
        "boundaryModeS",
        boundary(wrapS),
        "boundaryModeT",
        boundary(wrapT),
        "generateMipMaps",
        String.valueOf(mipmaps),
        "magnificationFilter",
        nearest ? "NEAREST_PIXEL" : "AVG_PIXEL",
        "minificationFilter",
        minification);
  }

  private static String boundary(int wrap) {
    return switch (wrap) {
      case CLAMP_TO_EDGE -> "CLAMP_TO_EDGE";
      case MIRRORED_REPEAT -> "MIRRORED_REPEAT";
      default -> "REPEAT";
    };
  }
}
