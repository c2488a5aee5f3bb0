package org.selectiverenderer.validation.language;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import org.selectiverenderer.validation.FileCheck;
import org.selectiverenderer.validation.FileContext;
import org.selectiverenderer.validation.FindingCollector;
import org.selectiverenderer.x3d.source.DocumentAttribute;
import org.selectiverenderer.x3d.source.DocumentElement;

/** Finds nodes and fields that were added after the X3D version that a file states. */
final class LanguageVersionCheck implements FileCheck {
  /**
   * The first X3D version by name: of a node {@code Node}, of a field {@code Node.field}, of a
   * field of all nodes {@code field}.
   */
  private final Map<String, String> since = new HashMap<>();

  private static final String NEWEST = HeadCheck.VERSIONS.get(HeadCheck.VERSIONS.size() - 1);

  LanguageVersionCheck() {
    try (InputStream in =
        Objects.requireNonNull(LanguageVersionCheck.class.getResourceAsStream("since.tsv"))) {
      String table = new String(in.readAllBytes(), StandardCharsets.UTF_8);
      table
          .lines()
          .skip(1)
          .forEach(
              line -> {
                String[] cells = line.split("\t");
                since.put(cells[0], cells[1]);
              });
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Override
  public void check(FileContext file, FindingCollector findings) {
    String version =
        file.document().root().flatMap(root -> root.text("version")).map(String::strip).orElse("");
    if (!HeadCheck.VERSIONS.contains(version) || version.equals(NEWEST)) {
      return;
    }
    Set<String> told = new HashSet<>();
    for (DocumentElement element : file.document().elements()) {
      if (file.catalogue().find(element.name()).isEmpty()) {
        continue;
      }
      String node = since.getOrDefault(element.name(), "3.0");
      if (node.compareTo(version) > 0) {
        if (told.add(element.name())) {
          findings.add(HeadRules.NEWER, element, element.name(), node, version);
        }
        continue;
      }
      for (DocumentAttribute attribute : element.attributes()) {
        String field = element.name() + "." + attribute.name();
        String came = since.getOrDefault(field, since.getOrDefault(attribute.name(), "3.0"));
        if (came.compareTo(version) > 0 && told.add(field)) {
          findings.add(
              HeadRules.NEWER,
              attribute,
              attribute.name() + " of " + element.name(),
              came,
              version);
        }
      }
    }
  }
}
