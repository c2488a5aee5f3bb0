package org.selectiverenderer.study.session;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.selectiverenderer.base.files.InputFileReader;
import org.selectiverenderer.study.definition.Study;

/**
 * The areas that a table of items may name: those of the study, those that it declares in {@code
 * item_areas}, and the parts of its scene: a ProximitySensor {@code BookcaseProx} or a schema
 * {@code BookcaseSchema} is the area {@code bookcase}. Only the scene's X3D files are read, as
 * text.
 */
final class KnownAreas {
  private static final Pattern SENSOR =
      Pattern.compile("<ProximitySensor\\b[^>]{0,2000}?\\bDEF\\s*=\\s*[\"']\\s*([^\"'\\s]{1,200})");

  private static final Pattern SCHEMA = Pattern.compile("[\"'\\s]([A-Za-z]\\w{0,200})Schema\\b");

  private static final List<String> ENDINGS =
      List.of("ProximitySensor", "Proximity", "Prox", "Sensor", "Schema", "Area");

  private KnownAreas() {}

  /**
   * Returns the names; empty if nothing tells them: the study declares none and has no scene, or a
   * scene of another encoding.
   *
   * @throws IOException if the scene cannot be read
   */
  static Optional<Set<String>> of(Study study) throws IOException {
    List<String> declared = study.questionnaires().itemAreas();
    Set<String> known = new LinkedHashSet<>();
    study.areas().forEach(area -> known.add(area.name()));
    known.addAll(declared);
    Optional<Path> scene = study.scene().filter(file -> file.toString().endsWith(".x3d"));
    if (scene.isEmpty()) {
      return declared.isEmpty() ? Optional.empty() : Optional.of(known);
    }
    // Another spelling of an area of the study would make another list of it.
    Set<String> taken = new LinkedHashSet<>();
    known.forEach(name -> taken.add(name.toLowerCase(Locale.ROOT)));
    for (String name : named(study, scene.get())) {
      for (String spelling : spellings(name)) {
        if (!taken.contains(spelling.toLowerCase(Locale.ROOT))) {
          known.add(spelling);
        }
      }
    }
    return Optional.of(known);
  }

  private static Set<String> named(Study study, Path scene) throws IOException {
    Set<String> names = new LinkedHashSet<>();
    for (String file : FileChecksumCalculator.ofScene(scene, study.access()).keySet()) {
      if (!file.endsWith(".x3d")) {
        continue;
      }
      String text =
          new String(
              InputFileReader.bytes(scene.toAbsolutePath().resolveSibling(file)),
              StandardCharsets.ISO_8859_1);
      for (Pattern pattern : List.of(SENSOR, SCHEMA)) {
        Matcher found = pattern.matcher(text);
        while (found.find()) {
          names.add(found.group(1));
        }
      }
    }
    return names;
  }

  private static List<String> spellings(String name) {
    String stem =
        ENDINGS.stream()
            .filter(ending -> name.endsWith(ending) && name.length() > ending.length())
            .findFirst()
            .map(ending -> name.substring(0, name.length() - ending.length()))
            .orElse(name);
    return List.of(stem.toLowerCase(Locale.ROOT), stem, name);
  }
}
