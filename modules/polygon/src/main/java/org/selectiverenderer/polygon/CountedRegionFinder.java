package org.selectiverenderer.polygon;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.selectiverenderer.base.problem.SpellingSuggester;
import org.selectiverenderer.x3d.read.ParsedNode;

/** Finds the parts of a scene that are counted, such as its rooms. */
final class CountedRegionFinder {
  private final CountGraphBuilder items;
  private final Map<String, ParsedNode> named;

  /**
   * @param named the nodes of the scene's own file by DEF name
   */
  CountedRegionFinder(CountGraphBuilder items, Map<String, ParsedNode> named) {
    this.items = items;
    this.named = named;
  }

  /**
   * Returns the groups of these names, each once.
   *
   * @throws UnknownRegionException if the scene has no group of a given name
   */
  List<CountedRegion> named(List<String> names) {
    return names.stream()
        .map(String::strip)
        .distinct()
        .map(name -> CountedRegion.of(name, group(name)))
        .toList();
  }

  /**
   * Returns the outermost named groups that contain enriched Switches. Returns the whole scene
   * instead if there is no such group, or if there are several groups of a single object each: such
   * a group only places one object and is not a part of the scene.
   */
  List<CountedRegion> outermost() {
    List<CountGraphNode> groups = new ArrayList<>();
    outermost(items.root(), groups, new HashSet<>());
    List<CountedRegion> scopes =
        groups.stream().map(group -> CountedRegion.of(group.name, group)).toList();
    boolean ofOneObject =
        scopes.size() > 1 && scopes.stream().allMatch(scope -> scope.objects().size() == 1);
    return scopes.isEmpty() || ofOneObject
        ? List.of(CountedRegion.of(SceneStatistics.WHOLE_SCENE, items.root()))
        : scopes;
  }

  private static void outermost(
      CountGraphNode item, List<CountGraphNode> found, Set<CountGraphNode> seen) {
    if (!item.varies || item.versions.isPresent() || !seen.add(item)) {
      return;
    }
    if (item.isNamed()) {
      found.add(item);
    } else {
      item.children.forEach(child -> outermost(child, found, seen));
    }
  }

  private CountGraphNode group(String name) {
    ParsedNode node = named.get(name);
    if (node == null) {
      throw new UnknownRegionException(
          "the scene has no group '%s'%s".formatted(name, suggestion(name)));
    }
    if (!DrawableNodeClassifier.isGroup(node.type())) {
      throw new UnknownRegionException(
          "%s: %s is a %s, not a group".formatted(node.location(), name, node.type().name()));
    }
    return items
        .of(node)
        .orElseThrow(
            () ->
                new UnknownRegionException(
                    "%s: group %s is not in a part of the scene that is drawn"
                        .formatted(node.location(), name)));
  }

  private String suggestion(String name) {
    List<String> groups =
        named.entrySet().stream()
            .filter(entry -> DrawableNodeClassifier.isGroup(entry.getValue().type()))
            .map(Map.Entry::getKey)
            .toList();
    return SpellingSuggester.nearest(name, groups)
        .map("; did you mean %s?"::formatted)
        .orElseGet(() -> some(groups));
  }

  /**
   * Returns the part of a message that lists the groups most likely meant: those with several
   * versioned objects.
   */
  private String some(List<String> groups) {
    List<String> first =
        groups.stream()
            .filter(
                group ->
                    items
                        .of(named.get(group))
                        .filter(CountedRegionFinder::holdsSeveral)
                        .isPresent())
            .limit(5)
            .toList();
    return first.isEmpty() ? "" : "; there are " + String.join(", ", first);
  }

  private static boolean holdsSeveral(CountGraphNode item) {
    return item.varies && CountedRegion.of(item.name, item).objects().size() > 1;
  }
}
