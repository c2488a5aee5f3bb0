package org.selectiverenderer.walkthrough;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import org.selectiverenderer.base.problem.SpellingSuggester;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.scene.Node;

/** Lists and finds the viewpoints of a scene by their DEF names and descriptions. */
public final class ViewpointFinder {
  /** The largest number of viewpoints that a message lists. */
  private static final int LISTED = 10;

  private ViewpointFinder() {}

  /**
   * A viewpoint with its name and description.
   *
   * @param name the DEF name; empty for none
   * @param description the author's description; empty for none
   */
  public record Entry(Node node, String name, String description) {
    static Entry of(Node node) {
      return new Entry(
          node,
          Optional.ofNullable(node.name()).orElse(""),
          node.value("description") instanceof String text ? text.strip() : "");
    }

    @Override
    public String toString() {
      if (name.isEmpty()) {
        return description.isEmpty() ? "one without a name" : "'" + description + "'";
      }
      return description.isEmpty() ? name : "%s ('%s')".formatted(name, description);
    }
  }

  /** Returns all viewpoints of a scene, Inlines included, in document order. */
  public static List<Entry> of(World world) {
    return world.views().viewpoints().stream().map(Entry::of).toList();
  }

  /**
   * Moves the viewer to a viewpoint before the first step.
   *
   * @param wanted the DEF name, else the description, else either of them ignoring case
   * @throws IOException with a sentence when there is none
   */
  public static void start(World world, String wanted) throws IOException {
    List<Entry> all = of(world);
    Node found =
        find(all, entry -> entry.name().equals(wanted))
            .or(() -> find(all, entry -> entry.description().equals(wanted.strip())))
            .or(() -> find(all, entry -> entry.name().equalsIgnoreCase(wanted)))
            .or(() -> find(all, entry -> entry.description().equalsIgnoreCase(wanted.strip())))
            .orElseThrow(() -> new IOException(unknown(wanted, all)));
    world.views().goTo(found);
  }

  private static Optional<Node> find(List<Entry> all, Function<Entry, Boolean> wanted) {
    return all.stream().filter(wanted::apply).map(Entry::node).findFirst();
  }

  private static String unknown(String wanted, List<Entry> all) {
    if (all.isEmpty()) {
      return "--viewpoint '%s': the scene has no viewpoints".formatted(wanted);
    }
    List<String> words = new ArrayList<>();
    all.forEach(
        entry -> {
          words.add(entry.name());
          words.add(entry.description());
        });
    String near =
        SpellingSuggester.nearest(wanted, words.stream().filter(word -> !word.isEmpty()).toList())
            .map("; did you mean '%s'?"::formatted)
            .orElse(";");
    List<String> listed = all.stream().limit(LISTED).map(Entry::toString).toList();
    int left = all.size() - listed.size();
    return "--viewpoint '%s': the scene has no such viewpoint%s It has %s%s"
        .formatted(
            wanted,
            near,
            String.join(", ", listed),
            left > 0 ? " and %d more, which --viewpoints lists".formatted(left) : "")
        .replace("; It has", "; it has");
  }
}
