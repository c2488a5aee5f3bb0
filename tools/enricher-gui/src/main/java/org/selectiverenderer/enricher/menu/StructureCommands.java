package org.selectiverenderer.enricher.menu;

import java.awt.datatransfer.Clipboard;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.StringSelection;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import org.joml.Vector3d;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.enrichment.EnrichedSwitch;
import org.selectiverenderer.authoring.nodes.NodeEdits;
import org.selectiverenderer.authoring.structure.ChildPosition;
import org.selectiverenderer.authoring.structure.NodePalette;
import org.selectiverenderer.authoring.structure.NodeTemplate;
import org.selectiverenderer.authoring.structure.StructureChange;
import org.selectiverenderer.authoring.structure.StructureEdits;
import org.selectiverenderer.authoring.switches.SwitchEdits;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.Remarks;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * The commands that change which nodes a scene has and where: cut, copy, paste, delete, duplicate,
 * move and insert. They act on all selected elements, each is one undo step, and what they put into
 * the scene is selected afterwards; a refused edit is reported in the status bar.
 */
public final class StructureCommands {
  /** How far beside a node whose size is unknown its duplicate is put, in metres. */
  private static final double ASIDE = 0.5;

  private final EnricherSession session;
  private final Clipboard clipboard;
  private Shifts shifts = (nodes, answer) -> answer.accept(node -> Optional.empty());

  public StructureCommands(EnricherSession session, Clipboard clipboard) {
    this.session = session;
    this.clipboard = clipboard;
  }

  /** Answers how far beside nodes their duplicates lie. */
  @FunctionalInterface
  public interface Shifts {
    /**
     * Answers the way from each node to its duplicate, in the coordinates of its parent; empty
     * where the node's size is unknown.
     *
     * @param answer is called later, on the event dispatch thread
     */
    void of(
        List<DocumentElement> nodes,
        Consumer<Function<DocumentElement, Optional<Vector3d>>> answer);
  }

  /** Sets what knows how far beside nodes their duplicates lie. */
  public void shifts(Shifts known) {
    shifts = known;
  }

  private SceneDocument document() {
    return session.document();
  }

  private StructureEdits edits() {
    return new StructureEdits(document(), session.catalogue());
  }

  private List<DocumentElement> selected() {
    return StructureEdits.outermost(session.selectedElements());
  }

  /** Whether nodes are selected that may be removed. */
  public boolean removable() {
    return !selected().isEmpty()
        && document().locked().isEmpty()
        && selected().stream().allMatch(NodeEdits::removable);
  }

  /** Whether there is a selection to copy. */
  public boolean copyable() {
    return !selected().isEmpty();
  }

  /** Puts the source of the selected nodes on the clipboard. */
  public void copy() {
    List<DocumentElement> nodes = selected();
    if (nodes.isEmpty()) {
      session.message(Texts.of("node.none"));
    } else if (put(edits().text(nodes))) {
      session.message(Texts.of("node.copied", shown(nodes)));
    }
  }

  private boolean put(String text) {
    try {
      clipboard.setContents(new StringSelection(text), null);
      return true;
    } catch (IllegalStateException e) {
      session.message(Texts.of("node.clipboardBusy"));
      return false;
    }
  }

  /** Puts the source of the selected nodes on the clipboard and removes them. */
  public void cut() {
    List<DocumentElement> nodes = selected();
    if (nodes.isEmpty()) {
      session.message(Texts.of("node.none"));
      return;
    }
    String text = edits().text(nodes);
    remove(nodes, () -> put(text), "Cut", "node.cutDone");
  }

  /** Removes the selected nodes. */
  public void delete() {
    List<DocumentElement> nodes = selected();
    if (nodes.isEmpty()) {
      session.message(Texts.of("node.none"));
      return;
    }
    remove(nodes, () -> true, "Delete", "node.deleteDone");
  }

  private interface Before {
    boolean done();
  }

  private void remove(List<DocumentElement> nodes, Before before, String verb, String told) {
    session.attempt(
        () -> {
          int routes = new NodeEdits(document()).references(nodes).size();
          Edit edit = removal(nodes, verb);
          String done = Texts.of(told, shown(nodes));
          Optional<DocumentElement> next = neighbour(nodes);
          if (!before.done()) {
            return;
          }
          Optional<Integer> place = next.map(each -> edit.moved(each.start()));
          document().perform(edit);
          session.select(
              place.flatMap(at -> document().tree().flatMap(tree -> tree.at(at))).orElse(null),
              document());
          session.message(
              routes == 0
                  ? done
                  : done + " " + Texts.of("node.routes", DecimalFormatter.grouped(routes), routes));
        });
  }

  private Edit removal(List<DocumentElement> nodes, String verb) {
    Optional<EnrichedSwitch> choice =
        nodes.size() == 1 ? switchAround(nodes.get(0)) : Optional.empty();
    if (choice.isPresent()) {
      Edit edit = switches().remove(choice.get(), index(choice.get(), nodes.get(0)));
      return verb.equals("Delete")
          ? edit
          : new Edit(verb + " " + nodes.get(0).def().orElse(nodes.get(0).name()), edit.changes());
    }
    return verb.equals("Delete") && nodes.size() == 1
        ? new NodeEdits(document()).remove(nodes.get(0))
        : edits().remove(nodes, verb);
  }

  private SwitchEdits switches() {
    return new SwitchEdits(session.enrichment(), session.catalogue());
  }

  /** Returns the Switch of which an element is a choice. */
  private Optional<EnrichedSwitch> switchAround(DocumentElement element) {
    return element
        .parent()
        .filter(parent -> parent.name().equals("Switch"))
        .flatMap(session.enrichment()::switchNode)
        .filter(node -> index(node, element) >= 0);
  }

  private static int index(EnrichedSwitch node, DocumentElement choice) {
    return node.choices().stream().map(EnrichedSwitch.ChoiceNode::element).toList().indexOf(choice);
  }

  /** Swaps a choice with the next one, with its metadata. */
  private void swap(EnrichedSwitch node, DocumentElement choice, boolean down) {
    int from = index(node, choice);
    int to = down ? from + 1 : from - 1;
    if (to < 0 || to >= node.choices().size()) {
      session.message(Texts.of(down ? "node.last" : "node.first"));
      return;
    }
    session.attempt(
        () -> {
          document().perform(switches().swap(node, from, to));
          session
              .enrichment()
              .switchNode(node.element())
              .ifPresent(now -> session.select(now.choices().get(to).element(), document()));
        });
  }

  /** Returns what is selected once nodes are gone: the next node, the one before, the parent. */
  private static Optional<DocumentElement> neighbour(List<DocumentElement> nodes) {
    DocumentElement last = nodes.get(nodes.size() - 1);
    return last.parent()
        .map(
            parent -> {
              List<DocumentElement> all = parent.children();
              int at = all.indexOf(last);
              for (int i = at + 1; i < all.size(); i++) {
                if (!nodes.contains(all.get(i)) && !all.get(i).name().equals("ROUTE")) {
                  return all.get(i);
                }
              }
              for (int i = at - 1; i >= 0; i--) {
                if (!nodes.contains(all.get(i))) {
                  return all.get(i);
                }
              }
              return parent;
            });
  }

  /** Pastes the clipboard's text into the selected node, or beside it. */
  public void paste() {
    try {
      String text = String.valueOf(clipboard.getData(DataFlavor.stringFlavor));
      perform(() -> edits().paste(session.selection(), text), "node.pasted");
    } catch (UnsupportedFlavorException | IOException e) {
      session.message(Texts.of("node.noText"));
    } catch (IllegalStateException e) {
      session.message(Texts.of("node.clipboardBusy"));
    }
  }

  /** Makes a change, selects what it has put into the scene and says so. */
  private boolean perform(Supplier<StructureChange> making, String told) {
    return session.attempt(
        () -> {
          StructureChange change = making.get();
          if (change.edit().isEmpty()) {
            return;
          }
          document().perform(change.edit());
          List<DocumentElement> added = change.elements(document());
          session.selectAll(added, document());
          session.message(
              added.isEmpty()
                  ? ""
                  : Texts.of(
                      told,
                      shown(added),
                      added.get(0).parent().map(DocumentElement::toString).orElse("")));
        });
  }

  private static String shown(List<DocumentElement> nodes) {
    return nodes.size() == 1
        ? nodes.get(0).toString()
        : Texts.of("node.several", DecimalFormatter.grouped(nodes.size()));
  }

  /** Puts a copy of each selected node beside it. */
  public void duplicate() {
    List<DocumentElement> nodes = selected();
    if (nodes.isEmpty()) {
      session.message(Texts.of("node.none"));
      return;
    }
    shifts.of(
        nodes,
        known -> {
          if (nodes.stream().allMatch(DocumentElement::attached)) {
            perform(
                () ->
                    edits()
                        .duplicate(
                            nodes,
                            node -> known.apply(node).orElseGet(() -> new Vector3d(ASIDE, 0, 0))),
                "node.duplicated");
          } else {
            session.message(Texts.of("node.changedMeanwhile"));
          }
        });
  }

  /** Moves the selected nodes one place up or down among their siblings. */
  public void step(boolean down) {
    List<DocumentElement> nodes = selected();
    if (nodes.isEmpty()) {
      session.message(Texts.of("node.none"));
    } else if (nodes.size() == 1 && switchAround(nodes.get(0)).isPresent()) {
      swap(switchAround(nodes.get(0)).get(), nodes.get(0), down);
    } else {
      perform(() -> edits().step(nodes, down), "node.moved");
    }
  }

  /** Returns why nodes cannot be moved or copied to a position; empty if they can. */
  public Optional<String> complaint(
      List<DocumentElement> nodes, ChildPosition position, boolean copy) {
    try {
      document().locked().ifPresent(StructureCommands::refuse);
      change(nodes, position, copy);
      return Optional.empty();
    } catch (EditRejectedException e) {
      return Optional.of(Remarks.of(e));
    }
  }

  private static void refuse(String why) {
    throw new EditRejectedException(why);
  }

  /** Moves or copies nodes to a position. */
  public void drop(List<DocumentElement> nodes, ChildPosition position, boolean copy) {
    perform(() -> change(nodes, position, copy), copy ? "node.pasted" : "node.moved");
  }

  private StructureChange change(
      List<DocumentElement> nodes, ChildPosition position, boolean copy) {
    return copy ? edits().copy(nodes, position) : edits().move(nodes, position);
  }

  /** Returns a valid name that no node of the document has, made from the wanted one. */
  public String free(String wanted) {
    return new NodeEdits(document()).free(wanted);
  }

  /** Returns what can be inserted. */
  public NodePalette palette() {
    return new NodePalette(document(), session.catalogue());
  }

  /**
   * Inserts a template into an element or behind it.
   *
   * @param goal empty for the end of the scene
   * @return whether it was inserted
   */
  public boolean insert(Optional<DocumentElement> goal, NodeTemplate template) {
    return perform(() -> palette().insert(goal, template), "node.inserted");
  }
}
