package org.selectiverenderer.export;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.SourceFormatter;
import org.selectiverenderer.authoring.UniqueNameGenerator;
import org.selectiverenderer.authoring.enrichment.DocumentEnrichment;
import org.selectiverenderer.authoring.enrichment.EnrichedSensor;
import org.selectiverenderer.authoring.enrichment.EnrichedSwitch;
import org.selectiverenderer.authoring.structure.InlinedContent;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ElementScope;
import org.selectiverenderer.x3d.source.TextEdit;

/**
 * Replaces the instances of prototypes with enriched nodes by what they stand for (X3D 4.0, 4.4.4),
 * as ROUTEs of a scene reach no node in a prototype, and removes the declarations of these.
 */
final class PrototypeFlattener {
  private static final String INSTANCE = "ProtoInstance";

  /** The largest number of instances that are replaced, so that no scene grows without limit. */
  private static final int MOST = 2_000;

  private final NodeCatalogue catalogue;
  private final ProblemCollector problems;

  PrototypeFlattener(NodeCatalogue catalogue, ProblemCollector problems) {
    this.catalogue = catalogue;
    this.problems = problems;
  }

  /** Changes a document; returns whether that could be done, else it is reported. */
  boolean flatten(SceneDocument document) {
    int replaced = 0;
    // Each replacement parses the document anew, so that the elements are found anew, too.
    while (true) {
      Map<String, DocumentElement> affected = affected(document);
      Optional<DocumentElement> next = next(document, affected);
      if (next.isEmpty()) {
        return removed(document, affected);
      }
      DocumentElement instance = next.get();
      DocumentElement declaration = affected.get(instance.text("name").orElseThrow());
      Optional<String> obstacle =
          ++replaced > MOST
              ? Optional.of("more than %d of them; fewer can be exported".formatted(MOST))
              : obstacle(document, instance, declaration);
      if (obstacle.isEmpty()) {
        obstacle = replace(document, instance, declaration);
      }
      if (obstacle.isPresent()) {
        problems.error(
            instance.location(),
            "the instance of the prototype %s, which has enriched nodes, cannot be written out: %s"
                .formatted(declaration.text("name").orElse(""), obstacle.get()));
        return false;
      }
    }
  }

  /** Returns the prototypes of the scene that hold enriched nodes, directly or by others. */
  private Map<String, DocumentElement> affected(SceneDocument document) {
    Set<DocumentElement> scopes = new HashSet<>();
    DocumentEnrichment nodes = new DocumentEnrichment(document, catalogue);
    nodes.switches().stream()
        .filter(EnrichedSwitch::controlled)
        .forEach(node -> scopes.add(ElementScope.of(node.element())));
    nodes.sensors().stream()
        .filter(EnrichedSensor::enriched)
        .forEach(node -> scopes.add(ElementScope.of(node.element())));
    Map<String, DocumentElement> affected = new LinkedHashMap<>();
    Map<String, DocumentElement> others = new LinkedHashMap<>();
    ElementScope.visit(
        document.tree().orElseThrow().root(),
        element -> {
          if (element.name().equals("ProtoDeclare")) {
            (scopes.contains(element) ? affected : others)
                .putIfAbsent(element.text("name").orElse(""), element);
          }
        });
    boolean more = !affected.isEmpty();
    while (more) {
      more = false;
      for (Map.Entry<String, DocumentElement> other : Map.copyOf(others).entrySet()) {
        if (descendants(other.getValue()).stream()
            .anyMatch(
                element -> instance(element) && affected.containsKey(text(element, "name")))) {
          affected.put(other.getKey(), other.getValue());
          others.remove(other.getKey());
          more = true;
        }
      }
    }
    return affected;
  }

  private static Optional<DocumentElement> next(
      SceneDocument document, Map<String, DocumentElement> affected) {
    List<DocumentElement> found = new ArrayList<>();
    ElementScope.visit(
        document.tree().orElseThrow().root(),
        element -> {
          if (instance(element) && affected.containsKey(text(element, "name"))) {
            found.add(element);
          }
        });
    return found.stream().findFirst();
  }

  /** Returns why an instance cannot be written out. */
  private static Optional<String> obstacle(
      SceneDocument document, DocumentElement instance, DocumentElement declaration) {
    Optional<String> def = instance.def();
    for (DocumentElement element : descendants(document.tree().orElseThrow().root())) {
      boolean routed =
          element.name().equals("ROUTE")
              && def.isPresent()
              && (element.text("fromNode").equals(def) || element.text("toNode").equals(def));
      if (routed) {
        return Optional.of("a ROUTE leads to it or from it; put the object itself into the scene");
      }
    }
    for (DocumentElement element : descendants(declaration)) {
      if (element != declaration && element.name().endsWith("ProtoDeclare")) {
        return Optional.of("its prototype declares another one; declare that before it");
      }
      if (instance(element) && text(element, "name").equals(text(declaration, "name"))) {
        return Optional.of("its prototype contains itself");
      }
    }
    return body(declaration).isEmpty() ? Optional.of("its prototype is empty") : Optional.empty();
  }

  /** Writes an instance out; returns why that cannot be done. */
  private static Optional<String> replace(
      SceneDocument document, DocumentElement instance, DocumentElement declaration) {
    var tree = document.tree().orElseThrow();
    List<DocumentElement> body = body(declaration);
    List<TextEdit> edits = new ArrayList<>();
    try {
      UniqueNameGenerator names = new UniqueNameGenerator(tree, instance);
      List<TextEdit> values = new PrototypeValues(document, instance, declaration, names).edits();
      InlinedContent content = new InlinedContent(document, body, names, values);
      List<String> group = new ArrayList<>(List.of(tag(instance)));
      List<String> rest = new ArrayList<>();
      List<String> routes = new ArrayList<>();
      boolean first = true;
      for (DocumentElement element : body) {
        List<String> lines = content.lines(element);
        if (element.name().equals("ROUTE")) {
          routes.addAll(lines);
        } else {
          // Only the first node of a body is drawn; the others take part in events.
          List<String> into = first ? group : rest;
          lines.forEach(line -> into.add("  " + line));
          first = false;
        }
      }
      if (!rest.isEmpty()) {
        group.add("  <Switch>");
        rest.forEach(line -> group.add("  " + line));
        group.add("  </Switch>");
      }
      group.add("</Group>");
      edits.add(document.layout().replace(instance, group));
      if (!routes.isEmpty()) {
        edits.add(document.layout().insertLast(tree.scene().orElseThrow(), routes));
      }
      edits.addAll(uses(document, instance));
      edits.sort(Comparator.comparingInt(TextEdit::from));
      document.perform(new Edit("Export", edits));
      return Optional.empty();
    } catch (EditRejectedException e) {
      return Optional.of(String.valueOf(e.getMessage()));
    }
  }

  private static String tag(DocumentElement instance) {
    StringBuilder tag = new StringBuilder("<Group");
    for (String name : List.of("DEF", "containerField")) {
      instance
          .text(name)
          .ifPresent(value -> tag.append(SourceFormatter.written(name, value, '\'')));
    }
    return tag.append('>').toString();
  }

  /** Makes Groups of the other places where an instance is used. */
  private static List<TextEdit> uses(SceneDocument document, DocumentElement instance) {
    List<TextEdit> edits = new ArrayList<>();
    ElementScope.visit(
        instance,
        element -> {
          if (element.name().equals(INSTANCE)
              && element.use().isPresent()
              && element.use().equals(instance.def())) {
            String use = SourceFormatter.written("USE", element.use().get(), '\'');
            edits.add(document.layout().replace(element, List.of("<Group" + use + "/>")));
          }
        });
    return edits;
  }

  /** Removes the declarations, whose nodes nobody shows any more. */
  private static boolean removed(SceneDocument document, Map<String, DocumentElement> affected) {
    if (!affected.isEmpty()) {
      List<TextEdit> edits = new ArrayList<>();
      affected.values().forEach(element -> edits.add(document.layout().remove(element)));
      edits.sort(Comparator.comparingInt(TextEdit::from));
      document.perform(new Edit("Export", edits));
    }
    return true;
  }

  private static List<DocumentElement> body(DocumentElement declaration) {
    return declaration.children().stream()
        .filter(child -> child.name().equals("ProtoBody"))
        .flatMap(body -> body.children().stream())
        .toList();
  }

  private static boolean instance(DocumentElement element) {
    return element.name().equals(INSTANCE) && element.use().isEmpty();
  }

  private static String text(DocumentElement element, String attribute) {
    return element.text(attribute).orElse("");
  }

  private static List<DocumentElement> descendants(DocumentElement element) {
    List<DocumentElement> all = new ArrayList<>();
    element.visit(all::add);
    return all;
  }
}
