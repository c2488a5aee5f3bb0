package org.selectiverenderer.export;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import org.selectiverenderer.authoring.packaging.PackagedFile;
import org.selectiverenderer.base.files.InputFileReader;
import org.selectiverenderer.x3d.source.Gzip;

/**
 * Tells whether a file may use tangents of surfaces: by a normal map, by anisotropy or in a shader.
 * X_ITE computes them for every model, a large part of its time to load an apartment.
 */
final class NormalMaps {
  /** Parts of the names of fields, of glTF's keys and of X_ITE's attributes of shaders. */
  private static final List<String> NAMES = List.of("ormalTexture", "nisotropy", "angent");

  /** Endings of files that name no nodes. */
  private static final Set<String> PLAIN =
      Set.of("png", "jpg", "jpeg", "gif", "webp", "bmp", "wav", "mp3", "ogg", "mp4", "webm", "hdr");

  private NormalMaps() {}

  /** Returns whether a file may use them. */
  static boolean mentioned(PackagedFile file) throws IOException {
    String name = file.target().toString().toLowerCase(Locale.ROOT);
    if (PLAIN.contains(name.substring(name.lastIndexOf('.') + 1))) {
      return false;
    }
    return mentioned(
        file.target(),
        file.changed().isPresent() ? file.changed().get() : InputFileReader.bytes(file.source()));
  }

  /** Returns whether a file with these bytes may use them; one that cannot be read may. */
  static boolean mentioned(Path name, byte[] bytes) {
    if (name.toString().toLowerCase(Locale.ROOT).endsWith(".x3db")) {
      return true; // its names are numbers
    }
    String text;
    try {
      byte[] plain = Gzip.compressed(bytes) ? Gzip.unpacked(bytes) : bytes;
      text = new String(plain, StandardCharsets.ISO_8859_1);
    } catch (IOException e) {
      return true;
    }
    return NAMES.stream().anyMatch(text::contains);
  }
}
