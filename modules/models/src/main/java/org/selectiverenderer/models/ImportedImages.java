package org.selectiverenderer.models;

import java.util.Base64;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.selectiverenderer.models.importer.ImportedModel.ImportedTexture;
import org.selectiverenderer.models.scene.PictureType;

/** The urls of the pictures of an imported model; a picture inside of it is encoded once. */
final class ImportedImages {
  private final List<ImportedTexture> textures;
  private final Map<Integer, String> encoded = new HashMap<>();

  /**
   * @param textures the pictures inside of the model
   */
  ImportedImages(List<ImportedTexture> textures) {
    this.textures = textures;
  }

  /**
   * Returns the url of a picture; "" for one in the file that is no PNG, JPEG or WebP.
   *
   * @param texture the path of the picture, or an asterisk and its index in the model
   */
  String url(String texture) {
    if (!texture.startsWith("*")) {
      // A name is no url: what ends its path, and a percent sign that escapes nothing, is encoded.
      String url =
          texture
              .replace('\\', '/')
              .replaceAll("%(?![0-9A-Fa-f]{2})", "%25")
              .replace("#", "%23")
              .replace("?", "%3F");
      // a drive of the author's machine
      return url.length() > 2 && url.charAt(1) == ':' && url.charAt(2) == '/'
          ? url.substring(url.lastIndexOf('/') + 1)
          : url;
    }
    int index;
    try {
      index = Integer.parseInt(texture.substring(1));
    } catch (NumberFormatException e) {
      return "";
    }
    return index >= 0 && index < textures.size()
        ? encoded.computeIfAbsent(index, i -> encode(textures.get(i).bytes()))
        : "";
  }

  private static String encode(byte[] bytes) {
    String type = PictureType.of(bytes);
    return type.isEmpty()
        ? ""
        : "data:" + type + ";base64," + Base64.getEncoder().encodeToString(bytes);
  }
}
