package org.selectiverenderer.validation.enrichment;

import java.util.List;
import java.util.Locale;
import org.joml.Vector3d;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.geometry.BoundingBox;
import org.selectiverenderer.polygon.EnrichmentPolygonModel.Version;
import org.selectiverenderer.polygon.EnrichmentPolygonModel.VersionedSwitch;
import org.selectiverenderer.schema.ConsistencyType;
import org.selectiverenderer.schema.VersionMetadata;
import org.selectiverenderer.validation.FindingCollector;

/** Checks the polygons and sizes of each object's versions against their metadata. */
final class ObjectVersionCheck implements EnrichedSceneCheck {
  private static final double MOST_OFF = 0.02;

  @Override
  public void check(EnrichedScene scene, FindingCollector findings) {
    scene
        .model()
        .ifPresent(
            model ->
                model
                    .objects()
                    .forEach(
                        object -> {
                          polygons(object, findings);
                          sizes(object, findings);
                        }));
  }

  /** Reports, of the pairs of versions in the wrong order, the pair that differs most. */
  private static void polygons(VersionedSwitch object, FindingCollector findings) {
    Pair worst = null;
    for (VersionMetadata a : object.schemas().choices()) {
      for (VersionMetadata b : object.schemas().choices()) {
        Pair pair = new Pair(object, a, b);
        if (pair.wrong() && (worst == null || pair.excess() > worst.excess())) {
          worst = pair;
        }
      }
    }
    if (worst != null) {
      findings.add(
          worst.ranked()
              ? ObjectVersionRules.DEGREE_AGAINST_POLYGONS
              : ObjectVersionRules.HEAVIER_REDUCTION,
          object.node(),
          worst.lighter.index(),
          worst.heavier.index(),
          DecimalFormatter.grouped(worst.polygons(worst.lighter)),
          DecimalFormatter.grouped(worst.polygons(worst.heavier)));
    }
  }

  /**
   * Two versions of an object.
   *
   * @param lighter the version that should have fewer polygons
   */
  private record Pair(VersionedSwitch object, VersionMetadata lighter, VersionMetadata heavier) {
    boolean wrong() {
      return !frame(lighter)
          && !frame(heavier)
          && (ranked() || reduced())
          && polygons(heavier) > 0
          && excess() > 0;
    }

    boolean ranked() {
      return lighter.consistency() > heavier.consistency();
    }

    /**
     * Returns whether the first version is a reduction of the second although the metadata give
     * both the same consistency: the second is the original, and the first comes later in the
     * Switch.
     */
    boolean reduced() {
      return heavier.index() == object.schemas().mostDetailed()
          && lighter.index() > heavier.index()
          && lighter.consistency() == heavier.consistency();
    }

    long polygons(VersionMetadata choice) {
      return object.versions().get(choice.index()).polygons();
    }

    long excess() {
      return polygons(lighter) - polygons(heavier);
    }

    private static boolean frame(VersionMetadata choice) {
      return choice.type().filter(ConsistencyType.FRAME::equals).isPresent();
    }
  }

  private static void sizes(VersionedSwitch object, FindingCollector findings) {
    int original = object.schemas().mostDetailed();
    List<Version> versions = object.versions();
    Version first = versions.get(original);
    for (int i = 0; i < versions.size(); i++) {
      Version version = versions.get(i);
      if (i != original && comparable(first) && comparable(version)) {
        double off = off(first.bounds(), version.bounds());
        if (off > MOST_OFF) {
          String percent = String.format(Locale.ROOT, "%.1f", 100 * off);
          findings.add(ObjectVersionRules.OTHER_SIZE, object.node(), i, percent, original);
        }
      }
    }
  }

  private static boolean comparable(Version version) {
    return version.exact() && !version.bounds().isEmpty();
  }

  /**
   * Returns the largest distance between corresponding sides of the boxes, as a share of the first
   * one's largest extent.
   */
  private static double off(BoundingBox a, BoundingBox b) {
    Vector3d low = b.min().sub(a.min()).absolute();
    Vector3d high = b.max().sub(a.max()).absolute();
    Vector3d most = low.max(high);
    double largest = a.extent();
    return largest > 0 ? most.get(most.maxComponent()) / largest : 0;
  }
}
