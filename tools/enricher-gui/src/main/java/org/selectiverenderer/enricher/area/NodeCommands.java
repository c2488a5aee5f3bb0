package org.selectiverenderer.enricher.area;

import java.util.Optional;
import java.util.function.Supplier;
import org.joml.Vector3d;
import org.selectiverenderer.document.Edit;
import org.selectiverenderer.document.EditRefused;
import org.selectiverenderer.document.area.AreaBox;
import org.selectiverenderer.document.area.AreaEdits;
import org.selectiverenderer.document.area.PlacedArea;
import org.selectiverenderer.document.area.PlacedAreas;
import org.selectiverenderer.document.enrichment.EnrichedSwitch;
import org.selectiverenderer.document.nodes.NodeEdits;
import org.selectiverenderer.document.switches.SwitchEdits;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * What is done with a node that is there: named, copied, deleted, an area put elsewhere. Each is
 * one step of Undo; what cannot be done is told in the status bar.
 */
public final class NodeCommands {
  /** How far beside an area its copy is, as part of its width. */
  private static final double BESIDE = 0.25;

  private final EnricherSession session;
  private final NodeEdits nodes;
  private final AreaEdits areas;
  private final SwitchEdits switches;

  public NodeCommands(EnricherSession session) {
    this.session = session;
    nodes = new NodeEdits(session.document());
    areas = new AreaEdits(session.enrichment());
    switches = new SwitchEdits(session.enrichment(), session.catalogue());
  }

  /** Makes edits of Switches. */
  public SwitchEdits switches() {
    return switches;
  }

  /** Whether an element is a node of its own, which can have a name and copies. */
  public boolean named(DocumentElement element) {
    boolean node =
        element.name().equals("ProtoInstance")
            || session.catalogue().find(element.name()).isPresent();
    return node && element.use().isEmpty();
  }

  /** The area that an element is, if it is one whose place is known. */
  public Optional<PlacedArea> area(DocumentElement element) {
    return element.attached()
        ? session
            .enrichment()
            .sensorNode(element)
            .flatMap(sensor -> PlacedAreas.of(session.enrichment(), sensor))
        : Optional.empty();
  }

  /** Why a node cannot be called that; empty if it can. */
  public Optional<String> complaint(String name) {
    try {
      nodes.check(name);
      return Optional.empty();
    } catch (EditRefused e) {
      return Optional.of(String.valueOf(e.getMessage()));
    }
  }

  /** A name that no node has. */
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

  /** Makes an edit and selects the node of a name. */
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
  public void rename(DocumentElement node, NameQuestion question) {
    String before = node.def().orElse("");
    String proposal = before.isEmpty() ? free(node.name()) : before;
    question
        .ask(
            Texts.of("area.rename.title", node.def().orElse(node.name())),
            proposal,
            name -> name.equals(before) ? Optional.empty() : complaint(name))
        .ifPresent(name -> perform(() -> nodes.rename(node, name)));
  }

  /**
   * Gives a node another name.
   *
   * @return why not; empty if it has it now
   */
  public Optional<String> rename(DocumentElement node, String name) {
    if (name.strip().equals(node.def().orElse(""))) {
      return Optional.empty();
    }
    Optional<String> why = complaint(name.strip());
    if (why.isEmpty()) {
      perform(() -> nodes.rename(node, name));
    }
    return why;
  }

  /** Puts a copy of a node beside it and selects it; an area a little aside, so that it is seen. */
  public void copy(DocumentElement node, Object origin) {
    String name = free(node.def().orElse(node.name()));
    Optional<PlacedArea> area = area(node);
    if (area.isPresent()) {
      Vector3d aside = new Vector3d(area.get().box().size().x() * BESIDE, 0, 0);
      perform(() -> areas.copy(area.get(), name, aside), name, origin);
    } else {
      perform(() -> nodes.copy(node, name), name, origin);
    }
  }

  /** Puts a copy of an area where it is wanted and selects it. */
  public void copy(PlacedArea area, Vector3d shift, Object origin) {
    String name = free(area.name());
    perform(() -> areas.copy(area, name, shift), name, origin);
  }

  /** Takes a node out. */
  public void delete(DocumentElement node) {
    perform(() -> nodes.remove(node));
  }

  /**
   * Puts an area's box elsewhere.
   *
   * @param verb key of the step's name in the bundle, which has the area's name put in
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

  /** Puts a node into a Switch and selects that. */
  boolean wrap(DocumentElement node, String name, Object origin) {
    return perform(() -> switches.wrap(node, name), name, origin);
  }

  /** The Switch that an element is. */
  public Optional<EnrichedSwitch> switchNode(DocumentElement element) {
    return element.attached() ? session.enrichment().switchNode(element) : Optional.empty();
  }
}
