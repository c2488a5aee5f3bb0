package org.selectiverenderer.authoring.structure;

import java.util.Collection;
import java.util.HashSet;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.x3d.source.DocumentElement;

/** The fields of one element that have their only node, while more nodes are given to it. */
final class FieldOccupancy {
  private final Containment containment;
  private final DocumentElement parent;
  private final Set<String> taken = new HashSet<>();

  /**
   * @param leaving children that do not stay in the element
   */
  FieldOccupancy(
      Containment containment, DocumentElement parent, Collection<DocumentElement> leaving) {
    this.containment = containment;
    this.parent = parent;
    for (DocumentElement child : parent.children()) {
      if (!leaving.contains(child)) {
        give(child);
      }
    }
  }

  /** Gives a node to the element; empty if no free field takes it. */
  Optional<Containment.Place> give(DocumentElement child) {
    Optional<Containment.Place> place = containment.place(parent, child, taken);
    place
        .filter(found -> !found.multiple())
        .flatMap(Containment.Place::field)
        .ifPresent(taken::add);
    return place;
  }
}
