package org.selectiverenderer.render.glsl;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.selectiverenderer.browser.instance.ShaderProgramSource.Stage;

/**
 * The built-in names that custom shaders expect to find declared: those of GLSL up to 1.20 and
 * those of X3D browsers. Read from {@code author-names.tsv}.
 */
final class BuiltInDeclarations {
  private static final String FILE = "/org/selectiverenderer/render/author-names.tsv";

  /** The prefix that replaces {@code gl_} in names that newer versions of GLSL do not know. */
  static final String OLD = "gl_";

  static final String NEW = "sr_";

  private final Map<Stage, Map<String, List<String>>> declarations = new LinkedHashMap<>();

  BuiltInDeclarations() {
    for (Stage stage : Stage.values()) {
      declarations.put(stage, new LinkedHashMap<>());
    }
    try (InputStream in = BuiltInDeclarations.class.getResourceAsStream(FILE)) {
      if (in == null) {
        throw new IllegalStateException("the program was built without " + FILE);
      }
      new String(in.readAllBytes(), StandardCharsets.UTF_8)
          .lines()
          .filter(line -> !line.isBlank() && !line.startsWith("#"))
          .forEach(this::read);
    } catch (IOException e) {
      throw new UncheckedIOException(FILE + " cannot be read", e);
    }
  }

  private void read(String line) {
    String[] cells = line.split("\t", 3);
    for (Stage stage : Stage.values()) {
      if (cells[0].indexOf(stage.name().charAt(0)) >= 0) {
        declarations
            .get(stage)
            .computeIfAbsent(now(cells[1]), name -> new ArrayList<>())
            .add(now(cells[2]));
      }
    }
  }

  /** Replaces the table's prefix {@code old_} by the prefix of compiled names. */
  private static String now(String text) {
    return text.replaceAll("\\bold_", NEW);
  }

  /** Returns the name that replaces an author's name in the compiled source. */
  String renamed(Stage stage, String name) {
    if (name.startsWith(OLD)) {
      String now = NEW + name.substring(OLD.length());
      return declarations.get(stage).containsKey(now) ? now : name;
    }
    return name;
  }

  /**
   * Returns the declarations of the built-in names that a source uses, each once, after the
   * declarations that they depend on.
   *
   * @param used the names that the compiled source uses
   * @param own the names that the source defines itself
   */
  String head(Stage stage, Set<String> used, Set<String> own) {
    Set<String> lines = new LinkedHashSet<>();
    for (String name : declarations.get(stage).keySet()) {
      if (used.contains(name) && !own.contains(name)) {
        declare(stage, name, own, lines);
      }
    }
    return lines.isEmpty() ? "" : String.join("\n", lines) + "\n";
  }

  private void declare(Stage stage, String name, Set<String> own, Set<String> lines) {
    for (String declaration : declarations.get(stage).get(name)) {
      for (String needed : GlslTokens.of(declaration).names()) {
        if (!needed.equals(name)
            && !own.contains(needed)
            && declarations.get(stage).containsKey(needed)) {
          declare(stage, needed, own, lines);
        }
      }
      lines.add(declaration);
    }
  }
}
