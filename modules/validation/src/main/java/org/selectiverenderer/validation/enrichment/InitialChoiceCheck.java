package org.selectiverenderer.validation.enrichment;

import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.joml.Vector3d;
import org.selectiverenderer.polygon.EnrichmentPolygonModel;
import org.selectiverenderer.polygon.EnrichmentPolygonModel.SensedArea;
import org.selectiverenderer.polygon.EnrichmentPolygonModel.VersionedSwitch;
import org.selectiverenderer.schema.SchemaActivation;
import org.selectiverenderer.validation.FindingCollector;
import org.selectiverenderer.x3d.read.ParsedNode;

/**
 * Checks whether each object initially shows the version that the schemas at the start viewpoint
 * require.
 */
final class InitialChoiceCheck implements EnrichedSceneCheck {
  /** A choice with the schema that requires it. */
  private record Claim(int choice, String schema) {}

  @Override
  public void check(EnrichedScene scene, FindingCollector findings) {
    EnrichmentPolygonModel model = scene.model().orElse(null);
    Vector3d eye = model == null ? null : StartPositionFinder.start(scene, model).orElse(null);
    if (model == null || eye == null) {
      return;
    }
    List<SensedArea> inside =
        model.areas().stream()
            .filter(area -> area.boxes().stream().anyMatch(box -> box.contains(eye)))
            .toList();
    Map<ParsedNode, Claim> entered = entered(model, inside);
    for (VersionedSwitch object : model.objects()) {
      int shown = object.whichChoice();
      boolean inRange = shown >= 0 && shown < object.versions().size();
      Claim claim = entered.get(object.node());
      if (claim == null && !claims(inside, object)) {
        claim = mainSchema(model, object).orElse(null);
      }
      if (claim != null
          && inRange
          && claim.choice != shown
          && !scene.driven(object.node(), "whichChoice")) {
        findings.addAt(
            ObjectVersionRules.NOT_AS_AT_START,
            scene.file(object.node()),
            object.node(),
            "whichChoice",
            shown,
            claim.schema,
            claim.choice);
      }
    }
  }

  /** Returns the choices that entering the areas around the viewer sets. */
  private static Map<ParsedNode, Claim> entered(
      EnrichmentPolygonModel model, List<SensedArea> inside) {
    SchemaActivation<ParsedNode, ParsedNode> activation = model.activation();
    Map<ParsedNode, Claim> claims = new HashMap<>();
    for (SensedArea area : inside) {
      activation
          .enter(area.sensor())
          .forEach(c -> claims.put(c.switchKey(), new Claim(c.to(), c.schema())));
    }
    return claims;
  }

  private static boolean claims(List<SensedArea> areas, VersionedSwitch object) {
    return areas.stream()
        .flatMap(area -> area.schemas().enter().stream())
        .anyMatch(object.schemas().choiceBySchema()::containsKey);
  }

  /** Returns the choice that leaving the areas sets, if all areas that affect the object agree. */
  private static Optional<Claim> mainSchema(EnrichmentPolygonModel model, VersionedSwitch object) {
    Map<String, Integer> choices = object.schemas().choiceBySchema();
    Set<Claim> claims = new HashSet<>();
    for (SensedArea area : model.areas()) {
      List<String> exit = area.schemas().exit();
      if (area.schemas().enter().stream().anyMatch(choices::containsKey)) {
        exit.stream()
            .filter(choices::containsKey)
            .reduce((earlier, later) -> later)
            .ifPresent(schema -> claims.add(new Claim(choices.get(schema), schema)));
      }
    }
    return claims.size() == 1 ? claims.stream().findFirst() : Optional.empty();
  }
}
