package org.selectiverenderer.radiosity.texel;

import java.util.Arrays;
import java.util.HashSet;
import java.util.Set;
import java.util.function.DoubleConsumer;
import org.selectiverenderer.radiosity.atlas.AtlasPage;
import org.selectiverenderer.radiosity.parallel.ParallelFor;
import org.selectiverenderer.radiosity.parallel.RadiosityProgress;
import org.selectiverenderer.radiosity.sampling.SobolPointSet;
import org.selectiverenderer.radiosity.scene.RadiosityScene;
import org.selectiverenderer.radiosity.solve.RadiositySolution;

/**
 * Irradiance caching of the indirect light: records are placed on grids of texels, the coarsest
 * grid first. A finer grid gets records where those of the coarser ones do not reach, and single
 * texels where light changes so much that no plane fits the records. The records of one grid do not
 * depend on each other, so the result is the same with any number of threads.
 */
final class IrradianceCachePass {
  private static final int[] STRIDES = {16, 8, 4, 2, 1};

  /**
   * Radius of validity of a record as a share of the harmonic mean distance to the surfaces visible
   * from it.
   */
  private static final double REACH = 0.15;

  /**
   * Limits of a record's radius, texels: the least one on grids, the least one at single texels,
   * and the largest.
   */
  private static final double LEAST = 2.4;

  private static final double LEAST_SINGLE = 1.4;
  private static final double MOST = 24;

  /** Sum of the weights of the records around below which a texel needs a record of its own. */
  private static final double KNOWN = 0.4;

  /**
   * Deviation of the records from their plane, as a share of the light, above which more records
   * are needed.
   */
  private static final double BENT = 0.03;

  /** Least light, as a share of the scene's mean light, that relative errors refer to. */
  private static final double DARK = 0.01;

  /** Share of the progress after which each record has its first rays. */
  private static final double GATHERED = 0.6;

  private final RadiosityScene scene;
  private final RadiositySolution solution;
  private final TexelIndex texels;
  private final TexelOcclusionPass nearby;
  private final float[] direct;
  private final int most;
  private final RecordGatherer gatherer;
  private final double noise;
  private final double dark;
  private final ChartSampleGrid[] grids;
  private final IrradianceCache records = new IrradianceCache();

  /**
   * @param noise the standard error of a record, as a share of its light, above which it gets more
   *     rays
   */
  IrradianceCachePass(
      RadiosityScene scene,
      RadiositySolution solution,
      TexelIndex texels,
      TexelOcclusionPass nearby,
      float[] direct,
      TexelRayCaster.Sets sets,
      double noise) {
    this.scene = scene;
    this.solution = solution;
    this.texels = texels;
    this.nearby = nearby;
    this.direct = direct;
    most = sets.rays();
    gatherer = new RecordGatherer(scene, solution, texels, direct, sets);
    this.noise = noise;
    dark = DARK * meanLight();
    grids =
        texels.atlas().pages().stream().map(ChartSampleGrid::new).toArray(ChartSampleGrid[]::new);
  }

  long rays() {
    return gatherer.rays();
  }

  /**
   * Returns the least light that noise is expressed as a share of; red, green and blue together,
   * lx.
   */
  double dark() {
    return dark;
  }

  IrradianceCache records() {
    return records;
  }

  /** Gathers the records; returns false if the work was cancelled. */
  boolean gather(RadiosityProgress progress, DoubleConsumer done) {
    for (int level = 0; level < STRIDES.length; level++) {
      int stride = STRIDES[level];
      double before = GATHERED * level / STRIDES.length;
      int[] places = new RecordThinning(gatherer.place()).of(wanting(stride, progress), stride);
      if (progress.cancelled()
          || !gather(
              places, stride, progress, d -> done.accept(before + GATHERED * d / STRIDES.length))) {
        return false;
      }
      records.index();
    }
    AdaptiveSampling rounds =
        new AdaptiveSampling(gatherer, nearby, direct, most, records, noise, dark);
    return rounds.run(progress, d -> done.accept(GATHERED + (1 - GATHERED) * d));
  }

  /** Returns the texels of a grid that need a record of their own. */
  private int[] wanting(int stride, RadiosityProgress progress) {
    int[][] byChunk = new int[texels.tiles()][];
    ParallelFor.run(
        texels.tiles(),
        64,
        progress,
        share -> {},
        (from, to) -> {
          Search search = new Search(stride);
          for (int tile = from; tile < to; tile++) {
            byChunk[tile] = search.of(tile);
          }
        });
    return Arrays.stream(byChunk)
        .filter(java.util.Objects::nonNull)
        .flatMapToInt(Arrays::stream)
        .toArray();
  }

  /** Searches for texels that need records. One per thread. */
  private final class Search {
    private final int stride;
    private final TexelSurfacePoint place = gatherer.place();
    private final IrradianceInterpolator reader = new IrradianceInterpolator(records);
    private final int[] list = new int[TexelIndex.TILE * TexelIndex.TILE];
    private int size;
    private int page = -1;
    private int found;

    Search(int stride) {
      this.stride = stride;
    }

    int[] of(int tile) {
      size = 0;
      found = 0;
      page = texels.pageOfTile(tile);
      texels.each(
          tile,
          texel -> {
            if (grids[page].on(texel - texels.first(page), stride)) {
              list[size++] = texel;
            }
          });
      for (int i = 0; i < size; i++) {
        if (wants(list[i])) {
          list[found++] = list[i];
        }
      }
      return Arrays.copyOf(list, found);
    }

    private boolean wants(int texel) {
      place.at(texel);
      reader.begin();
      reader.include(place.point);
      reader.find();
      if (!at(reader, texel, place) || reader.weight < KNOWN) {
        return true;
      }
      double there = reader.light[0] + reader.light[1] + reader.light[2] + sum(direct, texel);
      return reader.misfit > Math.max(BENT * there, 2 * reader.error);
    }
  }

  /** Interpolates at a surface point; returns whether some record is valid there. */
  boolean at(IrradianceInterpolator reader, int texel, TexelSurfacePoint place) {
    return reader.at(
        place.point, place.normal, place.flat(), group(place), nearby.reach(texel, place));
  }

  /**
   * Returns the group of a surface point: reference versions and bodies without versions see the
   * same scene, and any other version sees one of its own.
   */
  private int group(TexelSurfacePoint place) {
    return scene.versions().isReference(place.version) ? 0 : place.version;
  }

  private static double sum(float[] rgb, int texel) {
    return (double) rgb[3 * texel] + rgb[3 * texel + 1] + rgb[3 * texel + 2];
  }

  private boolean gather(
      int[] places, int stride, RadiosityProgress progress, DoubleConsumer done) {
    float[] block = new float[IrradianceCache.NUMBERS * places.length];
    int[] groups = new int[places.length];
    boolean whole =
        gatherer.gather(
            places,
            progress,
            done,
            (i, place, hemisphere, record) -> {
              hemisphere.gather(place, places[i], fewer(stride), record);
              groups[i] = record.seen ? group(place) : -1;
              IrradianceCache.write(
                  place, radius(record, place, stride), record, block, IrradianceCache.NUMBERS * i);
            });
    for (int i = 0; i < places.length && whole; i++) {
      if (groups[i] < 0) {
        texels.leave(places[i]);
      } else {
        records.add(block, IrradianceCache.NUMBERS * i, groups[i], places[i]);
      }
    }
    return whole;
  }

  /**
   * Returns the divisor of the rays of a record: dense records share their noise, so each needs
   * fewer.
   */
  private static int fewer(int stride) {
    return stride > 4 ? 1 : stride == 4 ? 2 : 4;
  }

  /**
   * Returns the mean irradiance on surfaces that are not buried, red, green and blue together, lx.
   */
  private double meanLight() {
    double sum = 0;
    double area = 0;
    for (int patch = 0; patch < solution.patches().count(); patch++) {
      if (!solution.buried()[patch]) {
        double own = solution.patches().area(patch);
        sum += own * (sum(solution.direct(), patch) + sum(solution.indirect(), patch));
        area += own;
      }
    }
    return area > 0 ? sum / area : 0;
  }

  private static double radius(IrradianceRecord record, TexelSurfacePoint place, int stride) {
    double least = (stride == 1 ? LEAST_SINGLE : LEAST) * place.size();
    return Math.max(least, Math.min(MOST * place.size(), REACH * record.distance));
  }

  /**
   * Thins out candidate texels for irradiance records: of texels that lie close together in space,
   * as those of many small charts do, only the first stays.
   */
  private static final class RecordThinning {
    private final TexelSurfacePoint place;

    RecordThinning(TexelSurfacePoint place) {
      this.place = place;
    }

    int[] of(int[] all, int stride) {
      Set<Long> taken = new HashSet<>();
      int[] kept = new int[all.length];
      int count = 0;
      for (int texel : all) {
        place.at(texel);
        if (taken.add(cell(Math.max(1, stride / 2)))) {
          kept[count++] = texel;
        }
      }
      return Arrays.copyOf(kept, count);
    }

    /**
     * Returns a hash key of a grid cube of about this many texels, of the version and of the
     * rounded normal.
     */
    private long cell(int side) {
      double size = Math.scalb(1.0, Math.getExponent(Math.max(1e-6, place.size() * side)));
      long key = place.version;
      for (int axis = 0; axis < 3; axis++) {
        key = 0x9e3779b97f4a7c15L * key + (long) Math.floor(place.point[axis] / size);
      }
      for (int axis = 0; axis < 3; axis++) {
        key = 0x9e3779b97f4a7c15L * key + Math.round(2 * place.normal[axis]);
      }
      return key ^ (long) SobolPointSet.hash((int) (key >>> 32)) << 7 ^ Math.getExponent(size);
    }
  }

  /**
   * Regular grids of texels, one for each chart and beginning at the lower left corner of the
   * chart, so that every chart has grid texels.
   */
  private static final class ChartSampleGrid {
    private final AtlasPage map;
    private final int lowest;
    private final int[] left;
    private final int[] bottom;

    ChartSampleGrid(AtlasPage map) {
      this.map = map;
      int low = Integer.MAX_VALUE;
      int high = -1;
      for (int chart : map.chart()) {
        if (chart != AtlasPage.NONE) {
          low = Math.min(low, chart);
          high = Math.max(high, chart);
        }
      }
      lowest = high < 0 ? 0 : low;
      left = new int[high - lowest + 1];
      bottom = new int[left.length];
      Arrays.fill(left, Integer.MAX_VALUE);
      Arrays.fill(bottom, Integer.MAX_VALUE);
      for (int i = 0; i < map.texels(); i++) {
        if (map.chart()[i] != AtlasPage.NONE) {
          int chart = map.chart()[i] - lowest;
          left[chart] = Math.min(left[chart], i % map.width());
          bottom[chart] = Math.min(bottom[chart], i / map.width());
        }
      }
    }

    /** Returns whether a texel of a chart is on the grid of a stride. */
    boolean on(int texel, int stride) {
      int chart = map.chart()[texel] - lowest;
      return (texel % map.width() - left[chart]) % stride == 0
          && (texel / map.width() - bottom[chart]) % stride == 0;
    }
  }
}
