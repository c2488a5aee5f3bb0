package org.selectiverenderer.polygon;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.polygon.SceneStatistics.ObjectCount;
import org.selectiverenderer.polygon.SceneStatistics.ScopeCount;
import org.selectiverenderer.schema.SwitchSchemas;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;

/** Counts the polygons of a scene. */
public final class ScenePolygonCounter {
  private final ProblemCollector problems;
  private final List<CountedRegion> scopes;
  private final boolean scopesChosen;
  private final CountGraphNode root;
  private final List<CountGraphNode> objects;
  private final AreaFinder areas;
  private final PolygonCounter high;
  private final CostCounter highCost;
  private final List<CountedTexture> textures;
  private final Map<CountedRegion, List<ActivationStateFinder.ActivationState>> found =
      new LinkedHashMap<>();

  ScenePolygonCounter(
      FilePolygonMeasurement file, List<String> scopeNames, ProblemCollector problems) {
    this.problems = problems;
    CountGraphBuilder items = new CountGraphBuilder(file, problems);
    root = items.root();
    objects = CountedRegion.of(SceneStatistics.WHOLE_SCENE, root).objects();
    CountedRegionFinder finder = new CountedRegionFinder(items, items.named());
    scopesChosen = !scopeNames.isEmpty();
    scopes = scopeNames.isEmpty() ? finder.outermost() : finder.named(scopeNames);
    areas = new AreaFinder(root, scopes);
    Map<ChoiceKey, Integer> choices = new LinkedHashMap<>();
    objects.forEach(object -> choices.put(object, object.versions.orElseThrow().mostDetailed()));
    textures = items.varying();
    textures.forEach(texture -> choices.put(texture, texture.schemas().mostDetailed()));
    high = new PolygonCounter(choices);
    highCost = new CostCounter(choices, textures);
  }

  /** Counts a scene that may refer only to files in its own folder. */
  public static SceneStatistics of(Path scene, List<String> scopes, ProblemCollector problems)
      throws IOException {
    return of(scene, scopes, ContentAccessPolicy.none(), problems);
  }

  /**
   * Reads a scene with everything that it inlines, on all processors, and counts.
   *
   * @param scopes DEF names of the groups to count; empty for the outermost named groups that
   *     contain versioned objects, or the whole scene if there are none
   * @param access further folders and hosts that the scene may refer to
   * @param problems receives the problems of the files, in document order
   * @throws IOException if the scene itself cannot be read, with a message of one line
   * @throws UnknownRegionException if the scene has no group of a given name
   */
  public static SceneStatistics of(
      Path scene, List<String> scopes, ContentAccessPolicy access, ProblemCollector problems)
      throws IOException {
    SceneFile file = SceneFileLoader.read(scene, access);
    return new ScenePolygonCounter(file, scopes, problems).count(scene.toString());
  }

  SceneStatistics count(String scene) {
    if (objects.isEmpty()) {
      problems.info(
          SourceLocation.of(scene),
          "no Switch has schema metadata, so there are no versions to compare; the "
              + "polygons that the scene shows are counted");
    }
    if (!areas.complete()) {
      problems.warning(
          SourceLocation.of(scene),
          "sensors and scopes occur at more than %d places; the rest are left out"
              .formatted(InstanceTransforms.LIMIT));
    }
    ActivationStateFinder states = new ActivationStateFinder(objects, textures, areas.all());
    List<ScopeCount> counts = new ArrayList<>();
    for (CountedRegion scope : scopes) {
      long all = high.of(scope.item());
      OverlappingAreaSets sets = new OverlappingAreaSets(areas.in(scope, scopes));
      if (!sets.complete()) {
        problems.warning(
            SourceLocation.of(scene),
            "the areas of %s overlap in more than %d ways; the rest are left out"
                .formatted(scope.name(), OverlappingAreaSets.LIMIT));
      }
      List<ActivationStateFinder.ActivationState> inScope = states.states(scope, sets.sets());
      found.put(scope, inScope);
      counts.add(
          new ScopeCount(
              scope.name(),
              all,
              inScope.stream().map(state -> state.count(all)).toList(),
              highCost.of(scope.item())));
    }
    return new SceneStatistics(scene, high.of(root), objectCounts(), counts);
  }

  /**
   * Returns the contributions of objects to the states of all scopes; to be called after {@link
   * #count}.
   */
  List<PolygonContributions> shares() {
    List<PolygonContributions> shares = new ArrayList<>();
    found.forEach(
        (scope, states) -> {
          Map<CountGraphNode, Integer> none = new LinkedHashMap<>();
          scope.objects().forEach(object -> none.put(object, -1));
          long fixed = new PolygonCounter(none).of(scope.item());
          InstanceTransforms places =
              new InstanceTransforms(scope.item(), new LinkedHashSet<>(scope.objects()));
          for (ActivationStateFinder.ActivationState state : states) {
            PolygonCounter counter = new PolygonCounter(state.shown());
            shares.add(
                new PolygonContributions(
                    scope.name(),
                    state.schemas(),
                    state.polygons(),
                    state.count(high.of(scope.item())).percent(),
                    fixed,
                    scope.objects().stream()
                        .map(object -> share(object, state, counter, places.of(object).size()))
                        .toList(),
                    state.cost()));
          }
        });
    return shares;
  }

  private PolygonContributions.ObjectShare share(
      CountGraphNode object,
      ActivationStateFinder.ActivationState state,
      PolygonCounter counter,
      int places) {
    return new PolygonContributions.ObjectShare(
        object.name,
        state.shown().getOrDefault(object, object.whichChoice()),
        object.children.stream().map(high::of).toList(),
        places,
        times(counter.of(object), places));
  }

  /** Returns the product, saturated as in {@link CountGraphNode#plus}. */
  private static long times(long polygons, int places) {
    return places > 0 && polygons > Long.MAX_VALUE / places ? Long.MAX_VALUE : polygons * places;
  }

  private List<ObjectCount> objectCounts() {
    List<ObjectCount> counts = new ArrayList<>();
    Set<CountGraphNode> outside = new LinkedHashSet<>(objects);
    for (CountedRegion scope : scopes) {
      for (CountGraphNode object : scope.objects()) {
        counts.add(count(object, Optional.of(scope.name())));
        outside.remove(object);
      }
    }
    if (!scopesChosen) {
      outside.forEach(object -> counts.add(count(object, Optional.empty())));
    }
    return counts;
  }

  private ObjectCount count(CountGraphNode object, Optional<String> scope) {
    SwitchSchemas versions = object.versions.orElseThrow();
    return new ObjectCount(
        object.name,
        scope,
        object.children.stream().map(high::of).toList(),
        versions.mostDetailed());
  }
}
