package org.selectiverenderer.authoring.switches;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.SourceFormatter;
import org.selectiverenderer.authoring.enrichment.ChoiceMetadata;
import org.selectiverenderer.authoring.enrichment.DocumentEnrichment;
import org.selectiverenderer.authoring.enrichment.EnrichedSwitch;
import org.selectiverenderer.authoring.enrichment.EnrichedSwitch.ChoiceNode;
import org.selectiverenderer.authoring.enrichment.EnrichmentEdits;
import org.selectiverenderer.authoring.enrichment.EnrichmentEdits.SwitchMetadata;
import org.selectiverenderer.authoring.nodes.NodeEdits;
import org.selectiverenderer.authoring.nodes.Reindenter;
import org.selectiverenderer.authoring.structure.NeededComponents;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.TextEdit;
import org.selectiverenderer.x3d.write.FieldValueFormatter;

/**
 * Creates edits of Switches and their choices. Each edit is for the document's present state and is
 * performed by {@link SceneDocument#perform}; an edit that would change nothing is empty. All throw
 * {@link EditRejectedException} with a sentence for the author where an edit cannot be made.
 */
public final class SwitchEdits {
  private final SceneDocument document;
  private final EnrichmentEdits metadata;
  private final NodeCatalogue catalogue;
  private final NodeEdits nodes;
  private final NeededComponents components;

  public SwitchEdits(DocumentEnrichment enrichment, NodeCatalogue catalogue) {
    this.document = enrichment.document();
    this.metadata = new EnrichmentEdits(enrichment);
    this.catalogue = catalogue;
    this.nodes = new NodeEdits(document);
    this.components = new NeededComponents(document, catalogue);
  }

  /** Wraps a node in a new Switch that shows it. */
  public Edit wrap(DocumentElement node, String name) {
    check(node);
    nodes.check(name);
    SourceFormatter layout = document.layout();
    char quote = layout.quote(node);
    String open =
        "<Switch"
            + SourceFormatter.written("DEF", name, quote)
            + SourceFormatter.written("whichChoice", "0", quote)
            + ">";
    String text = Reindenter.wrapped(document, node, open, "</Switch>");
    List<TextEdit> changes = new ArrayList<>(components.of(Set.of("Switch")));
    changes.add(new TextEdit(node.start(), node.end(), text));
    return new Edit("Make the Switch " + name, changes);
  }

  /**
   * Returns a name for the Switch of a node, from its DEF or USE name, else from its type, which is
   * the prototype for an instance.
   */
  public String proposedName(DocumentElement node) {
    String name = node.def().or(node::use).or(() -> prototype(node)).orElse(node.name());
    String object = name.replaceFirst("^(Transform|Group|Inline|Shape)_", "");
    return nodes.free("Switch_" + object);
  }

  private static Optional<String> prototype(DocumentElement node) {
    return node.name().equals("ProtoInstance") ? node.text("name") : Optional.empty();
  }

  /** Returns whether a node can be wrapped in a Switch. */
  public boolean wraps(DocumentElement node) {
    boolean shown =
        node.name().equals("ProtoInstance")
            || catalogue.find(node.name()).filter(type -> type.is("X3DChildNode")).isPresent();
    boolean place =
        node.parent()
            .filter(
                parent ->
                    parent.name().equals("Scene")
                        || catalogue
                            .find(parent.name())
                            .filter(type -> type.field("children").isPresent())
                            .isPresent())
            .isPresent();
    boolean field = node.text("containerField").filter(at -> !at.equals("children")).isPresent();
    return shown && place && !field && !node.name().equals("Switch");
  }

  /**
   * Checks that a node can be wrapped in a Switch.
   *
   * @throws EditRejectedException if it cannot
   */
  public void check(DocumentElement node) {
    if (node.name().equals("Switch")) {
      throw new EditRejectedException(node + " is a Switch already; add a choice to it instead");
    }
    if (!wraps(node)) {
      throw new EditRejectedException(
          "only a node that is drawn by itself can be put into a Switch; choose a Transform, Group,"
              + " Shape or Inline, not "
              + node.name());
    }
  }

  /** Replaces a Switch by its initially shown choice, else by its first one. */
  public Edit unwrap(EnrichedSwitch node) {
    if (node.choices().isEmpty()) {
      throw new EditRejectedException(
          node.name() + " has no choice to replace it; delete it instead");
    }
    DocumentElement element = node.element();
    int shown =
        node.whichChoice() < 0 ? 0 : Math.min(node.whichChoice(), node.choices().size() - 1);
    DocumentElement kept = node.choices().get(shown).element();
    List<TextEdit> changes = new ArrayList<>();
    if (element.def().isPresent()) {
      changes.addAll(ownReferences(element));
    }
    for (ChoiceNode choice : node.choices()) {
      if (choice.index() != shown) {
        // Only references that would dangle afterwards are removed.
        changes.addAll(nodes.released(choice.element()));
      }
    }
    SourceFormatter layout = document.layout();
    String text = document.text(kept);
    boolean laid = layout.onItsOwnLine(kept);
    String step =
        laid && layout.indentation(kept).startsWith(layout.indentation(element))
            ? layout.indentation(kept).substring(layout.indentation(element).length())
            : "";
    changes.add(new TextEdit(element.start(), element.end(), Reindenter.shallower(text, step)));
    return new Edit(
        "Unwrap " + node.name(),
        changes.stream().distinct().filter(change -> outside(change, element)).toList());
  }

  private static boolean outside(TextEdit change, DocumentElement element) {
    boolean whole = change.from() == element.start() && change.to() == element.end();
    return whole || change.to() <= element.start() || change.from() >= element.end();
  }

  /** Removes the references to the Switch itself, not those to the remaining choice. */
  private List<TextEdit> ownReferences(DocumentElement element) {
    return nodes.releasedItself(element);
  }

  /** Sets the initially shown choice; -1 for none. */
  public Edit show(EnrichedSwitch node, int choice) {
    List<TextEdit> changes =
        choice == node.whichChoice()
            ? List.of()
            : List.of(document.layout().attribute(node.element(), "whichChoice", "" + choice));
    return new Edit("Show choice %d of %s".formatted(choice, node.name()), changes);
  }

  /** Adds an empty choice. */
  public Edit addEmpty(EnrichedSwitch node) {
    return added(node, "Add an empty choice to " + node.name(), "Group", "<Group/>");
  }

  /**
   * Adds an Inline as a choice.
   *
   * @param url the URL relative to the scene's folder
   */
  public Edit addInline(EnrichedSwitch node, String url) {
    char quote = document.layout().quote(node.element());
    String name = nodes.free("Inline_%s_v%d".formatted(node.object(), node.choices().size() + 1));
    return added(
        node,
        "Add a choice to " + node.name(),
        "Inline",
        "<Inline"
            + SourceFormatter.written("DEF", name, quote)
            + SourceFormatter.written(
                "url", FieldValueFormatter.strings(url), quote == '"' ? '\'' : quote)
            + "/>");
  }

  /** Adds a copy of a choice at the end, with new DEF names for all named nodes in it. */
  public Edit addCopy(EnrichedSwitch node, int index) {
    DocumentElement from = node.choices().get(index).element();
    DocumentElement last = last(node);
    TextEdit copy =
        nodes.copied(from, nodes.free(from.def().orElse(node.object() + "_v")), List.of());
    List<TextEdit> changes = new ArrayList<>(metadata.choiceAdded(node));
    changes.add(new TextEdit(last.end(), last.end(), copy.text()));
    return new Edit("Copy choice %d of %s".formatted(index, node.name()), changes);
  }

  private static DocumentElement last(EnrichedSwitch node) {
    return node.choices().get(node.choices().size() - 1).element();
  }

  private Edit added(EnrichedSwitch node, String name, String type, String line) {
    SourceFormatter layout = document.layout();
    List<TextEdit> changes = new ArrayList<>(components.of(Set.of(type)));
    if (node.choices().isEmpty()) {
      changes.add(layout.insertLast(node.element(), List.of(line)));
    } else {
      changes.addAll(metadata.choiceAdded(node));
      changes.add(layout.insertAfter(last(node), List.of(line)));
    }
    return new Edit(name, changes);
  }

  /** Removes a choice and its metadata. */
  public Edit remove(EnrichedSwitch node, int index) {
    List<TextEdit> changes = new ArrayList<>(nodes.removal(node.choices().get(index).element()));
    changes.addAll(metadata.choiceRemoved(node, index));
    int shown = node.whichChoice();
    int left = node.choices().size() - 1;
    int then = shown > index || shown == left ? shown - 1 : shown;
    if (then != shown) {
      changes.add(document.layout().attribute(node.element(), "whichChoice", "" + then));
    }
    return new Edit("Delete choice %d of %s".formatted(index, node.name()), changes);
  }

  /** Swaps two choices with their metadata. */
  public Edit swap(EnrichedSwitch node, int one, int other) {
    int first = Math.min(one, other);
    int second = Math.max(one, other);
    if (first == second) {
      return new Edit("", List.of());
    }
    DocumentElement a = node.choices().get(first).element();
    DocumentElement b = node.choices().get(second).element();
    List<ChoiceMetadata> values = new ArrayList<>(node.values());
    values.set(first, node.values().get(second));
    values.set(second, node.values().get(first));
    List<TextEdit> changes = new ArrayList<>();
    changes.addAll(
        metadata.all("", List.of(new SwitchMetadata(node, values)), List.of()).changes());
    changes.add(new TextEdit(a.start(), a.end(), document.text(b)));
    changes.add(new TextEdit(b.start(), b.end(), document.text(a)));
    int shown = node.whichChoice();
    if (shown == first || shown == second) {
      int then = shown == first ? second : first;
      changes.add(document.layout().attribute(node.element(), "whichChoice", "" + then));
    }
    return new Edit("Move choice %d of %s".formatted(one, node.name()), changes);
  }
}
