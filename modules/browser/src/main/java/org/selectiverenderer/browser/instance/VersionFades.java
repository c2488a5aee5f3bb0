package org.selectiverenderer.browser.instance;

import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import org.selectiverenderer.browser.scene.Node;

/**
 * The cross-fades of a tree's Switches. While one lasts, a renderer draws the child that was left
 * besides the one that is shown, each in its share of the pixels. Only drawing is concerned: rays,
 * collisions, sensors and polygon counts follow the child that is shown.
 */
public final class VersionFades {
  /**
   * A version during a fade.
   *
   * @param shapes the shapes that it draws
   * @param coming whether it is the new version
   * @param threshold value of an ordered pattern, from 0 to 1, that divides the pixels of the two
   *     versions
   * @param below whether the version has the pixels whose value is below the threshold; the other
   *     version has the others
   */
  public record FadingVersion(
      List<ShapeInstance> shapes, boolean coming, double threshold, boolean below) {}

  private final InstanceTree tree;
  private final List<Fade> fades = new ArrayList<>();
  private double time;

  VersionFades(InstanceTree tree) {
    this.tree = tree;
  }

  /**
   * Begins a fade of all instances of a Switch. A change back during a fade goes back from where
   * that one has come.
   *
   * @param from index of the child that is left; none may have it
   * @param to index of the child that is shown from now on; none may have it
   * @param seconds duration, above 0
   */
  public void begin(Node switchNode, int from, int to, double seconds) {
    for (Instance instance : tree.instances(switchNode)) {
      if (instance instanceof GroupInstance group && group.shown()) {
        Fade fade = new Fade(group, from, to, seconds);
        fades.stream().filter(known -> known.group == group).forEach(fade::after);
        fades.removeIf(known -> known.group == group && known.end());
        fade.collect();
        fades.add(fade);
      }
    }
  }

  /**
   * Sets the time, ends the fades that are over, and follows changes of the tree. To be called
   * after the tree's update.
   *
   * @param now seconds, not less than before
   */
  public void at(double now) {
    time = now;
    for (Iterator<Fade> all = fades.iterator(); all.hasNext(); ) {
      Fade fade = all.next();
      if (fade.share() >= 1 || fade.group.disposed || !fade.group.shown()) {
        fade.end();
        all.remove();
      } else {
        fade.follow();
      }
    }
  }

  /** Returns the versions that are being faded, in the order in which their fades began. */
  public List<FadingVersion> versions() {
    if (fades.isEmpty()) {
      return List.of();
    }
    List<FadingVersion> versions = new ArrayList<>();
    for (Fade fade : fades) {
      double threshold = fade.back ? 1 - fade.share() : fade.share();
      versions.add(new FadingVersion(fade.leaving, false, threshold, fade.back));
      versions.add(new FadingVersion(fade.coming, true, threshold, !fade.back));
    }
    return versions;
  }

  /** A fade of one instance of a Switch. */
  private final class Fade {
    final GroupInstance group;
    final int from;
    final int to;
    private double start = time;
    private final double seconds;
    private long structure;
    private List<ShapeInstance> leaving = List.of();
    private List<ShapeInstance> coming = List.of();

    /** Whether the new version grows from the other end of the pattern. */
    private boolean back;

    Fade(GroupInstance group, int from, int to, double seconds) {
      this.group = group;
      this.from = from;
      this.to = to;
      this.seconds = seconds;
    }

    /** Goes back from where a fade of the opposite direction has come, pixel by pixel. */
    void after(Fade other) {
      if (other.from == to && other.to == from) {
        start = time - (1 - other.share()) * seconds;
        back = !other.back;
      }
    }

    /** Returns the share of pixels that the new version has. */
    double share() {
      return Math.max(0, Math.min(1, (time - start) / seconds));
    }

    void follow() {
      if (structure != tree.structureVersion()) {
        end();
        collect();
      }
    }

    void collect() {
      structure = tree.structureVersion();
      leaving = shapes(from);
      coming = shapes(to);
      leaving.forEach(shape -> shape.fading = true);
      coming.forEach(shape -> shape.fading = true);
    }

    /** Lets the shapes be drawn as usual again. */
    boolean end() {
      leaving.forEach(shape -> shape.fading = false);
      coming.forEach(shape -> shape.fading = false);
      return true;
    }

    private List<ShapeInstance> shapes(int child) {
      List<ShapeInstance> found = new ArrayList<>();
      if (child >= 0 && child < group.children.size()) {
        collect(group.children.get(child), found);
      }
      return List.copyOf(found);
    }

    /** Collects the shapes that an instance draws where it is shown. */
    private static void collect(Instance instance, List<ShapeInstance> found) {
      if (instance instanceof ShapeInstance shape && shape.look().visible()) {
        found.add(shape);
      } else if (instance instanceof GroupInstance inner) {
        for (int i = 0; i < inner.children.size(); i++) {
          if (inner.node().shows(i)) {
            collect(inner.children.get(i), found);
          }
        }
      }
    }
  }
}
