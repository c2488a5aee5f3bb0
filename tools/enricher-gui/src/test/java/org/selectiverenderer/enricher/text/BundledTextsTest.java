package org.selectiverenderer.enricher.text;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** What the window shows stands in the bundles, not in its code. */
class BundledTextsTest {
  private static final Path SOURCES =
      Path.of("tools/enricher-gui/src/main/java/org/selectiverenderer/enricher");
  private static final Pattern SHOWN =
      Pattern.compile(
          "(?:new J(?:Label|Button|ToggleButton|CheckBox|RadioButton|Menu|MenuItem|PopupMenu)"
              + "|new KeyedAction|new EditRefused|setText|setToolTipText|setAccessibleName"
              + "|setAccessibleDescription|setTitle|setDialogTitle|addTab|message|tell|say)"
              + "\\(\\s*(?:[\\w.()]+ \\+ )?\"([^\".<][^\"]*\\p{L}{2}[^\"]*)\"");

  /** Words of X3D, the same in all languages, and names that no one sees. */
  private static final Set<String> WORDS =
      Set.of("whichChoice", "Preview", "Schemas", "Source", "Plan", "Help");

  @Test
  void whatTheWindowShowsIsInTheBundles() throws IOException {
    List<String> found = new ArrayList<>();
    List<Path> sources;
    try (Stream<Path> files = Files.walk(SOURCES)) {
      sources = files.filter(file -> file.toString().endsWith(".java")).toList();
    }
    for (Path source : sources) {
      Matcher shown = SHOWN.matcher(Files.readString(source));
      while (shown.find()) {
        if (!WORDS.contains(shown.group(1))) {
          found.add(source.getFileName() + ": " + shown.group(1));
        }
      }
    }
    assertThat(sources).isNotEmpty();
    assertThat(found).isEmpty();
  }
}
