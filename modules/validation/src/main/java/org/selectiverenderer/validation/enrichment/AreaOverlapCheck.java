package org.selectiverenderer.validation.enrichment;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.polygon.EnrichmentPolygonModel;
import org.selectiverenderer.polygon.EnrichmentPolygonModel.SensedArea;
import org.selectiverenderer.polygon.EnrichmentPolygonModel.VersionedSwitch;
import org.selectiverenderer.validation.FindingCollector;

/**
 * Finds overlapping areas that show different versions of an object. An area inside another one,
 * such as a desk in an office, is no conflict: it is always entered last and left first.
 */
final class AreaOverlapCheck implements EnrichedSceneCheck {
  @Override
  public void check(EnrichedScene scene, FindingCollector findings) {
    scene.model().ifPresent(model -> check(model, findings));
  }

  private static void check(EnrichmentPolygonModel model, FindingCollector findings) {
    List<SensedArea> areas = model.areas();
    for (int i = 0; i < areas.size(); i++) {
      for (SensedArea other : areas.subList(i + 1, areas.size())) {
        SensedArea area = areas.get(i);
        if (area.shares(other) && !area.surrounds(other) && !other.surrounds(area)) {
          model.objects().forEach(object -> check(object, area, other, findings));
        }
      }
    }
  }

  private static void check(
      VersionedSwitch object, SensedArea area, SensedArea other, FindingCollector findings) {
    Map<String, Integer> choices = object.schemas().choiceBySchema();
    Optional<Integer> one = SchemaPrecedence.choice(area.schemas().enter(), choices);
    Optional<Integer> two = SchemaPrecedence.choice(other.schemas().enter(), choices);
    if (one.isPresent() && two.isPresent() && !one.equals(two)) {
      findings.add(
          ObjectVersionRules.ORDER_DEPENDENT,
          object.node(),
          area.name(),
          other.name(),
          one.get(),
          two.get());
    }
  }
}
