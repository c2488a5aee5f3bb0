package org.selectiverenderer.models;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import java.util.regex.Pattern;
import org.selectiverenderer.models.importer.ModelFileSource.OpenFile;

/**
 * Corrects material libraries (MTL) of exporters to whom {@code Tr} is the opacity, 1 for all that
 * is opaque: VTK, whose exporter PyVista and ParaView use, too, and Jmol. Everywhere else it is the
 * transparency, so that nothing of such a model would be seen.
 */
final class MaterialLibraryDialect {
  private static final String ENDING = ".mtl";
  private static final List<String> SIGNATURES =
      List.of("written by the visualization toolkit", "created by jmol");

  /** Exporters write their signatures into the first line. */
  private static final int BEGINNING = 200;

  /** A library of materials is small; a larger file is passed on as it is. */
  private static final int LARGEST = 1 << 24;

  private static final Pattern OPACITY = Pattern.compile("(?m)^([ \\t]*)Tr(?=[ \\t])");

  private MaterialLibraryDialect() {}

  /**
   * Returns a file with {@code Tr} replaced by {@code d}, the word for the opacity, if it is a
   * material library of one of these exporters; else the file with the same bytes.
   *
   * @param url the url of the file as the model states it
   * @param file the file, open
   */
  static OpenFile corrected(String url, OpenFile file) throws IOException {
    if (!url.toLowerCase(Locale.ROOT).endsWith(ENDING) || file.size() > LARGEST) {
      return file;
    }
    byte[] bytes;
    try (InputStream content = file.content()) {
      bytes = content.readNBytes((int) file.size());
    }
    // Each byte is one character of it, whatever the names are encoded in.
    String text = new String(bytes, StandardCharsets.ISO_8859_1);
    String beginning =
        text.substring(0, Math.min(BEGINNING, text.length())).toLowerCase(Locale.ROOT);
    if (SIGNATURES.stream().anyMatch(beginning::contains)) {
      bytes = OPACITY.matcher(text).replaceAll("$1d").getBytes(StandardCharsets.ISO_8859_1);
    }
    return new OpenFile(bytes.length, new ByteArrayInputStream(bytes));
  }
}
