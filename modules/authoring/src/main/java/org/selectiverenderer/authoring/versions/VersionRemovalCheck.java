package org.selectiverenderer.authoring.versions;

import java.util.List;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.x3d.catalogue.NodeView;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * Checks whether versions of an object can be removed. A Switch whose {@code whichChoice} is a
 * missing child shows nothing (X3D 4.0, 10.4.4), and the metadata of a removed version would select
 * such a child.
 */
final class VersionRemovalCheck {
  private final ElementNodeMapping scene;
  private final ObjectElements.Versioned site;
  private final ProblemCollector problems;

  VersionRemovalCheck(
      ElementNodeMapping scene, ObjectElements.Versioned site, ProblemCollector problems) {
    this.scene = scene;
    this.site = site;
    this.problems = problems;
  }

  /**
   * Returns whether the versions after the first {@code left} can be removed; reports the
   * obstacles.
   */
  boolean possible(int left) {
    List<DocumentElement> going = site.inlines().stream().skip(left).toList();
    if (going.isEmpty()) {
      return true;
    }
    NodeView choice = scene.node(site.choice());
    int shown = choice == null ? -1 : choice.integer("whichChoice");
    for (DocumentElement inline : going) {
      if (choice != null && choice.nodes("children").indexOf(scene.node(inline)) == shown) {
        return refuse(
            site.choice().location(), "whichChoice shows", site.inlines().indexOf(inline));
      }
    }
    List<DocumentElement> sets = sets();
    if (sets.size() > left) {
      return refuse(sets.get(left).location(), "the metadata here describes", left);
    }
    return new CrossFileReferences(scene, problems).unused(site.name(), going);
  }

  /** Returns the MetadataSets of the versions: MetadataSet i describes child i (thesis Fig 52). */
  private List<DocumentElement> sets() {
    List<DocumentElement> sets = sets(site.choice());
    return sets.size() == 1 && !sets(sets.get(0)).isEmpty() ? sets(sets.get(0)) : sets;
  }

  private static List<DocumentElement> sets(DocumentElement of) {
    return of.children().stream().filter(child -> child.name().equals("MetadataSet")).toList();
  }

  private boolean refuse(SourceLocation location, String why, int index) {
    problems.error(
        location,
        "%s version %d of the object '%s', which would be removed; change this first;"
                .formatted(why, index + 1, site.name())
            + " nothing has been changed");
    return false;
  }
}
