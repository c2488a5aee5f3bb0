package org.selectiverenderer.enricher.area;

import java.util.Optional;
import java.util.function.Supplier;
import org.joml.Vector3d;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.area.AreaBox;
import org.selectiverenderer.authoring.area.AreaEdits;
import org.selectiverenderer.authoring.area.AreaInstance;
import org.selectiverenderer.authoring.area.AreaLocator;
import org.selectiverenderer.authoring.enrichment.EnrichedSwitch;
import org.selectiverenderer.authoring.nodes.NodeEdits;
import org.selectiverenderer.authoring.switches.SwitchEdits;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.Remarks;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * The commands for existing nodes: rename, copy, delete, and move or resize an area. Each is one
 * undo step; a refused edit is reported in the status bar.
 */
public final class NodeCommands {
  /** How far beside an area its copy is put, as a share of its width. */
  private static final double BESIDE = 0.25;

  private final EnricherSession session;
  private final NodeEdits nodes;
  private final AreaEdits areas;
  private final SwitchEdits switches;

  public NodeCommands(EnricherSession session) {
    this.session = session;
    nodes = new NodeEdits(session.document());
    areas = new AreaEdits(session.enrichment(), session.catalogue());
    switches = new SwitchEdits(session.enrichment(), session.catalogue());
  }

  /** The factory of the edits of Switches. */
  public SwitchEdits switches() {
    return switches;
  }

  /**
   * Whether an element is a node or a prototype instance, and no USE, so that it can be named and
   * copied.
   */
  public boolean named(DocumentElement element) {
    boolean node =
        element.name().equals("ProtoInstance")
            || session.catalogue().find(element.name()).isPresent();
    return node && element.use().isEmpty();
  }

  /** The area that an element is; empty if it is none or its position in the scene is unknown. */
  public Optional<AreaInstance> area(DocumentElement element) {
    return element.attached()
        ? session
            .enrichment()
            .sensorNode(element)
            .flatMap(sensor -> AreaLocator.of(session.enrichment(), sensor))
        : Optional.empty();
  }

  /** Why a node of the scene cannot have this name; empty if it can. */
  public Optional<String> complaint(String name) {
    return complaint(() -> nodes.check(name));
  }

  private Optional<String> complaint(DocumentElement node, String name) {
    return complaint(() -> nodes.check(name, node));
  }

  private static Optional<String> complaint(Runnable check) {
    try {
      check.run();
      return Optional.empty();
    } catch (EditRejectedException e) {
      return Optional.of(Remarks.of(e));
    }
  }

  /** Returns a name that no node has, made from the wanted one. */
  public String free(String wanted) {
    return nodes.free(wanted);
  }

  /**
   * Makes an edit that may be refused.
   *
   * @return whether it was made
   */
  public boolean perform(Supplier<Edit> edit) {
    return session.attempt(() -> session.document().perform(edit.get()));
  }

  /** Makes an edit and selects the node of this name. */
  public boolean perform(Supplier<Edit> edit, String name, Object origin) {
    boolean made = perform(edit);
    if (made) {
      session
          .document()
          .tree()
          .flatMap(tree -> tree.named(name))
          .ifPresent(element -> session.select(element, origin));
    }
    return made;
  }

  /** Asks for another name of a node. */
  public void rename(DocumentElement node, NamePrompt question) {
    String before = node.def().orElse("");
    String proposal = before.isEmpty() ? nodes.free(node.name(), node) : before;
    question
        .ask(
            Texts.of("area.rename.title", node.def().orElse(node.name())),
            proposal,
            name -> name.equals(before) ? Optional.empty() : complaint(node, name))
        .ifPresent(name -> perform(() -> nodes.rename(node, name)));
  }

  /**
   * Gives a node another name.
   *
   * @return why it cannot have the name; empty if it has it now
   */
  public Optional<String> rename(DocumentElement node, String name) {
    if (name.strip().equals(node.def().orElse(""))) {
      return Optional.empty();
    }
    Optional<String> why = complaint(node, name.strip());
    if (why.isEmpty()) {
      perform(() -> nodes.rename(node, name));
    }
    return why;
  }

  /**
   * Puts a copy of a node after it and selects the copy; the copy of an area is shifted a little,
   * so that it is seen.
   */
  public void copy(DocumentElement node, Object origin) {
    String name = nodes.free(node.def().orElse(node.name()), node);
    Optional<AreaInstance> area = area(node);
    if (area.isPresent()) {
      Vector3d aside = new Vector3d(area.get().box().size().x() * BESIDE, 0, 0);
      perform(() -> areas.copy(area.get(), name, aside), name, origin);
    } else {
      if (perform(() -> nodes.copy(node, name))) {
        session
            .document()
            .tree()
            .flatMap(tree -> tree.named(name, node))
            .ifPresent(copy -> session.select(copy, origin));
      }
    }
  }

  /** Puts a shifted copy of an area into the scene and selects it. */
  public void copy(AreaInstance area, Vector3d shift, Object origin) {
    String name = free(area.name());
    perform(() -> areas.copy(area, name, shift), name, origin);
  }

  /** Deletes a node. */
  public void delete(DocumentElement node) {
    perform(() -> nodes.remove(node));
  }

  /**
   * Moves or resizes an area's box.
   *
   * @param verb key of the undo step's name in the bundle {@code area}, whose argument is the
   *     area's name
   */
  public boolean place(DocumentElement sensor, AreaBox box, String verb) {
    return area(sensor)
        .map(area -> perform(() -> areas.place(area, box, Texts.of("area." + verb, area.name()))))
        .orElse(false);
  }

  /** Adds an area and selects it. */
  boolean add(String name, AreaBox box, Object origin) {
    return perform(() -> areas.add(name, box), name, origin);
  }

  /** Wraps a node in a Switch and selects the Switch. */
  boolean wrap(DocumentElement node, String name, Object origin) {
    return perform(() -> switches.wrap(node, name), name, origin);
  }

  /** The Switch that an element is; empty if it is none. */
  public Optional<EnrichedSwitch> switchNode(DocumentElement element) {
    return element.attached() ? session.enrichment().switchNode(element) : Optional.empty();
  }
}
