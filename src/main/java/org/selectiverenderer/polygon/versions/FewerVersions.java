package org.selectiverenderer.polygon.versions;

import java.util.List;
import org.selectiverenderer.x3d.Location;
import org.selectiverenderer.x3d.NodeView;
import org.selectiverenderer.x3d.Problems;
import org.selectiverenderer.x3d.SceneElement;

/**
 * Finds what would be about a version that goes: a Switch that chooses a child which is not there
 * shows nothing (X3D 4.0, 10.4.4), and metadata without its version make it do so.
 */
final class FewerVersions {
  private final SceneSource scene;
  private final ObjectSite.Versioned site;
  private final Problems problems;

  FewerVersions(SceneSource scene, ObjectSite.Versioned site, Problems problems) {
    this.scene = scene;
    this.site = site;
    this.problems = problems;
  }

  /** Whether the versions after the first ones can go; reports what hinders them. */
  boolean possible(int left) {
    List<SceneElement> going = site.inlines().stream().skip(left).toList();
    if (going.isEmpty()) {
      return true;
    }
    NodeView choice = scene.node(site.choice());
    int shown = choice == null ? -1 : choice.integer("whichChoice");
    for (SceneElement inline : going) {
      if (choice != null && choice.nodes("children").indexOf(scene.node(inline)) == shown) {
        return refuse(
            site.choice().location(), "whichChoice shows", site.inlines().indexOf(inline));
      }
    }
    List<SceneElement> sets = sets();
    if (sets.size() > left) {
      return refuse(sets.get(left).location(), "the metadata here are about", left);
    }
    return new TiesCheck(scene, problems).free(site.name(), going);
  }

  /** The MetadataSets of the versions: MetadataSet i describes child i (thesis Fig 52). */
  private List<SceneElement> sets() {
    List<SceneElement> sets = sets(site.choice());
    return sets.size() == 1 && !sets(sets.get(0)).isEmpty() ? sets(sets.get(0)) : sets;
  }

  private static List<SceneElement> sets(SceneElement of) {
    return of.children().stream().filter(child -> child.name().equals("MetadataSet")).toList();
  }

  private boolean refuse(Location location, String why, int index) {
    problems.error(
        location,
        "%s version %d of the object '%s', which fewer versions would take away; change that first;"
                .formatted(why, index + 1, site.name())
            + " nothing has been changed");
    return false;
  }
}
