package org.selectiverenderer.validation.enrichment;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.polygon.count.SceneModel;
import org.selectiverenderer.polygon.count.SceneModel.SensedArea;
import org.selectiverenderer.polygon.count.SceneModel.VersionedSwitch;
import org.selectiverenderer.validation.Findings;

/**
 * Finds overlapping areas that show different versions of an object. An area inside another one,
 * such as a desk in an office, is no conflict: it is always entered last and left first.
 */
final class OverlapCheck implements EnrichmentPart {
  @Override
  public void check(EnrichedScene scene, Findings findings) {
    scene.model().ifPresent(model -> check(model, findings));
  }

  private static void check(SceneModel model, Findings findings) {
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
      VersionedSwitch object, SensedArea area, SensedArea other, Findings findings) {
    Map<String, Integer> choices = object.schemas().choiceBySchema();
    Optional<Integer> one = LastNamed.choice(area.schemas().enter(), choices);
    Optional<Integer> two = LastNamed.choice(other.schemas().enter(), choices);
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
