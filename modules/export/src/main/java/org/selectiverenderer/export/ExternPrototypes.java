package org.selectiverenderer.export;

import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.UniqueNameGenerator;
import org.selectiverenderer.authoring.structure.InlinedContent;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.TextEdit;

/**
 * Declares a prototype of another file in the scene itself (X3D 4.0, 4.4.5), with those that it
 * uses, so that its instances can be written out.
 */
final class ExternPrototypes {
  private final SceneFiles files;

  /** Names by which prototypes of a file were declared directly in the scene of a document. */
  private final Map<SceneDocument, Map<Path, Map<String, String>>> taken = new IdentityHashMap<>();

  ExternPrototypes(SceneFiles files) {
    this.files = files;
  }

  /**
   * Returns why a prototype cannot be declared in the scene.
   *
   * @param circle whether the prototype's file inlines the one that takes it, or takes from it
   */
  Optional<String> obstacle(
      DocumentElement external, SceneDocument content, SceneFiles.Target target, boolean circle) {
    String what = "the prototype %s, whose file has enriched nodes, cannot be taken in: ";
    what = what.formatted(external.text("name").orElse(""));
    Optional<DocumentElement> wanted = wanted(content, target);
    if (wanted.isEmpty()) {
      String missing = target.fragment().isEmpty() ? "prototype" : target.fragment();
      return Optional.of(
          what + "%s declares no %s".formatted(files.display(target.file()), missing));
    }
    if (circle
        && needed(content, wanted.get()).stream()
            .anyMatch(each -> each.name().equals("ExternProtoDeclare"))) {
      return Optional.of(
          what + "files take it from one another; declare it without EXTERNPROTO in one of them");
    }
    return SceneFiles.elements(content).stream().anyMatch(each -> each.name().equals("unit"))
        ? Optional.of(what + "its file has units of its own; write it in the scene's units")
        : Optional.empty();
  }

  /**
   * Returns the changes of the scene that put the declarations in the place of that of a prototype
   * of another file.
   *
   * @param file the file of the scene
   * @throws org.selectiverenderer.authoring.EditRejectedException if that cannot be done, with the
   *     reason
   */
  List<TextEdit> edits(
      SceneDocument document,
      DocumentElement external,
      SceneDocument content,
      Path file,
      SceneFiles.Target target) {
    DocumentElement wanted = wanted(content, target).orElseThrow();
    boolean shared = external.parent().filter(at -> at.name().equals("Scene")).isPresent();
    Map<String, String> known =
        shared
            ? taken
                .computeIfAbsent(document, key -> new HashMap<>())
                .computeIfAbsent(target.file(), key -> new HashMap<>())
            : Map.of(); // a declaration within a prototype is known there alone
    List<DocumentElement> needed =
        needed(content, wanted).stream()
            .filter(element -> element.equals(wanted) || !known.containsKey(name(element)))
            .toList();
    Set<String> own = new LinkedHashSet<>();
    needed.forEach(element -> own.add(name(element)));
    own.remove(name(wanted));
    Map<String, String> renamed = PrototypeNames.renamed(own, PrototypeNames.declared(document));
    if (shared) {
      needed.forEach(
          element ->
              known.putIfAbsent(name(element), renamed.getOrDefault(name(element), name(element))));
      known.remove(name(wanted)); // its own name in the scene may hide a helper's
    }
    known.forEach(renamed::put);
    renamed.put(name(wanted), name(external));
    List<TextEdit> changes = new ArrayList<>(files.urls(content, target.file(), file));
    changes.addAll(PrototypeNames.edits(content, renamed));
    InlinedContent inside =
        new InlinedContent(
            content,
            needed,
            new UniqueNameGenerator(document.tree().orElseThrow(), external),
            changes);
    List<String> lines = new ArrayList<>();
    needed.forEach(element -> lines.addAll(inside.lines(element)));
    List<TextEdit> edits = new ArrayList<>();
    edits.add(document.layout().replace(external, lines));
    edits.addAll(new HeadMerger(document).include(content));
    edits.sort(Comparator.comparingInt(TextEdit::from));
    return edits;
  }

  /** Returns the declaration that a url names: without a name it is the first of the file. */
  private static Optional<DocumentElement> wanted(SceneDocument content, SceneFiles.Target target) {
    Map<String, DocumentElement> declared = declared(content);
    return target.fragment().isEmpty()
        ? declared.values().stream().findFirst()
        : Optional.ofNullable(declared.get(target.fragment()));
  }

  private static Map<String, DocumentElement> declared(SceneDocument content) {
    Map<String, DocumentElement> declared = new LinkedHashMap<>();
    content.tree().orElseThrow().scene().map(DocumentElement::children).orElse(List.of()).stream()
        .filter(element -> PrototypeNames.DECLARATIONS.contains(element.name()))
        .forEach(element -> declared.putIfAbsent(name(element), element));
    return declared;
  }

  /** Returns a declaration and those that its nodes are instances of, in the file's order. */
  private static List<DocumentElement> needed(SceneDocument content, DocumentElement wanted) {
    Map<String, DocumentElement> declared = declared(content);
    Set<DocumentElement> needed = new LinkedHashSet<>(List.of(wanted));
    Deque<DocumentElement> open = new ArrayDeque<>(needed);
    while (!open.isEmpty()) {
      open.pop()
          .visit(
              element -> {
                DocumentElement used =
                    element.name().equals("ProtoInstance") ? declared.get(name(element)) : null;
                if (used != null && needed.add(used)) {
                  open.push(used);
                }
              });
    }
    return declared.values().stream().filter(needed::contains).toList();
  }

  private static String name(DocumentElement element) {
    return element.text("name").orElse("");
  }
}
