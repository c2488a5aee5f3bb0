package org.selectiverenderer.export;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.SourceFormatter;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.TextEdit;

/**
 * Extends the profile and the components that a scene names (X3D 4.0, 7.2.5) by those that a file
 * needs whose content it takes over.
 */
final class HeadMerger {
  private static final List<String> PROFILES =
      List.of("Core", "Interchange", "Interactive", "Immersive", "Full");

  private final SceneDocument scene;

  HeadMerger(SceneDocument scene) {
    this.scene = scene;
  }

  /** Returns the changes of the scene's head. */
  List<TextEdit> include(SceneDocument other) {
    DocumentElement root = scene.tree().orElseThrow().root();
    DocumentElement otherRoot = other.tree().orElseThrow().root();
    List<TextEdit> edits = new ArrayList<>();
    String now = root.text("profile").orElse("");
    String wanted = profile(now, otherRoot.text("profile").orElse(now));
    if (!wanted.equals(now)) {
      edits.add(scene.layout().attribute(root, "profile", wanted));
    }
    Map<String, Integer> levels = components(root);
    List<String> lines = new ArrayList<>();
    components(otherRoot)
        .forEach(
            (name, level) -> {
              if (levels.getOrDefault(name, 0) < level) {
                lines.add(
                    "<component"
                        + SourceFormatter.written("name", name, '\'')
                        + SourceFormatter.written("level", Integer.toString(level), '\'')
                        + "/>");
              }
            });
    if (!lines.isEmpty()) {
      Optional<DocumentElement> head = head(root);
      if (head.isPresent()) {
        edits.add(scene.layout().insertFirst(head.get(), lines));
      } else {
        List<String> all = new ArrayList<>(List.of("<head>"));
        lines.forEach(line -> all.add("  " + line));
        all.add("</head>");
        edits.add(scene.layout().insertFirst(root, all));
      }
    }
    return edits;
  }

  private static String profile(String one, String other) {
    int first = PROFILES.indexOf(one);
    int second = PROFILES.indexOf(other);
    if (one.equals(other)) {
      return one;
    }
    return first < 0 || second < 0 ? "Full" : PROFILES.get(Math.max(first, second));
  }

  private static Optional<DocumentElement> head(DocumentElement root) {
    return root.children().stream().filter(child -> child.name().equals("head")).findFirst();
  }

  private static Map<String, Integer> components(DocumentElement root) {
    Map<String, Integer> levels = new HashMap<>();
    for (DocumentElement child : head(root).map(DocumentElement::children).orElse(List.of())) {
      if (child.name().equals("component")) {
        String level = child.text("level").orElse("1").strip();
        levels.merge(
            child.text("name").orElse(""),
            level.matches("[0-9]{1,4}") ? Integer.parseInt(level) : 1,
            Math::max);
      }
    }
    return levels;
  }
}
