package org.selectiverenderer.authoring.structure;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import org.selectiverenderer.authoring.DocumentSnapshot;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.SourceFormatter;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.catalogue.Profile;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ElementTree;
import org.selectiverenderer.x3d.source.TextEdit;

/**
 * The component statements that a file needs for nodes beyond its profile (X3D 4.0, 7.2.5.3). A
 * file that declares no profile, or an unknown one, gets none.
 */
public final class NeededComponents {
  private final Supplier<Optional<ElementTree>> tree;
  private final Supplier<SourceFormatter> layout;
  private final NodeCatalogue catalogue;

  private NeededComponents(
      Supplier<Optional<ElementTree>> tree,
      Supplier<SourceFormatter> layout,
      NodeCatalogue catalogue) {
    this.tree = tree;
    this.layout = layout;
    this.catalogue = catalogue;
  }

  /** Creates statements for a document with nodes of a catalogue. */
  public NeededComponents(SceneDocument document, NodeCatalogue catalogue) {
    this(document::tree, document::layout, catalogue);
  }

  /** Creates statements for the elements of a snapshot with nodes of a catalogue. */
  public NeededComponents(
      DocumentSnapshot snapshot, ElementTree elements, NodeCatalogue catalogue) {
    this(() -> Optional.of(elements), snapshot::layout, catalogue);
  }

  /** Returns the changes of the head that declare what elements need. */
  List<TextEdit> of(List<DocumentElement> elements) {
    Set<String> names = new LinkedHashSet<>();
    elements.forEach(element -> element.visit(each -> names.add(each.name())));
    return of(names);
  }

  /** Returns the changes of the head that declare what nodes need. */
  public List<TextEdit> of(Set<String> names) {
    Optional<DocumentElement> root =
        tree.get().map(ElementTree::root).filter(found -> found.name().equals("X3D"));
    Optional<Profile> profile = root.flatMap(found -> found.text("profile")).flatMap(Profile::of);
    if (profile.isEmpty()) {
      return List.of();
    }
    Map<String, Integer> levels =
        profile.get().missing(names.stream().flatMap(name -> catalogue.find(name).stream()));
    return levels.isEmpty() ? List.of() : declared(root.get(), levels);
  }

  private List<TextEdit> declared(DocumentElement root, Map<String, Integer> levels) {
    SourceFormatter formatter = layout.get();
    List<TextEdit> changes = new ArrayList<>();
    Optional<DocumentElement> head =
        root.children().stream().filter(child -> child.name().equals("head")).findFirst();
    List<DocumentElement> known =
        head.stream()
            .flatMap(found -> found.children().stream())
            .filter(child -> child.name().equals("component"))
            .toList();
    for (DocumentElement component : known) {
      Integer level = levels.remove(Profile.component(component.text("name").orElse("").strip()));
      if (level != null && level > number(component.text("level").orElse("1"))) {
        changes.add(formatter.attribute(component, "level", level.toString()));
      }
    }
    char quote = formatter.quote(root);
    List<String> lines = new ArrayList<>();
    levels.forEach(
        (name, level) ->
            lines.add(
                "<component"
                    + SourceFormatter.written("name", name, quote)
                    + SourceFormatter.written("level", level.toString(), quote)
                    + "/>"));
    if (lines.isEmpty()) {
      return changes;
    }
    if (head.isEmpty()) {
      lines.add(0, "<head>");
      lines.replaceAll(line -> line.startsWith("<component") ? "  " + line : line);
      lines.add("</head>");
      changes.add(formatter.insertFirst(root, lines));
    } else if (known.isEmpty()) {
      changes.add(formatter.insertFirst(head.get(), lines));
    } else {
      changes.add(formatter.insertAfter(known.get(known.size() - 1), lines));
    }
    return changes;
  }

  private static int number(String text) {
    try {
      return Integer.parseInt(text.strip());
    } catch (NumberFormatException e) {
      return 0; // a fault that the validator reports; the right level replaces it
    }
  }
}
