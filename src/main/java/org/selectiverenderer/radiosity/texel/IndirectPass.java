package org.selectiverenderer.radiosity.texel;

import java.util.Arrays;
import java.util.concurrent.atomic.LongAdder;
import java.util.function.DoubleConsumer;
import org.selectiverenderer.radiosity.scene.LightScene;
import org.selectiverenderer.radiosity.solve.Solution;
import org.selectiverenderer.radiosity.work.ParallelWork;
import org.selectiverenderer.radiosity.work.WorkProgress;

/**
 * Irradiance caching of the indirect light: records are placed on grids of texels, the coarsest
 * grid first. A finer grid gets records where those of the coarser ones do not reach, and single
 * texels where light changes so much that no plane fits the records. The records of one grid do not
 * depend on each other, so the result is the same with any number of threads.
 */
final class IndirectPass {
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

  private final LightScene scene;
  private final Solution solution;
  private final Texels texels;
  private final NearbyPass nearby;
  private final float[] direct;
  private final TexelRays.Sets sets;
  private final double noise;
  private final double dark;
  private final ChartGrid[] grids;
  private final LightRecords records = new LightRecords();
  private final LongAdder rays = new LongAdder();

  /**
   * @param noise the standard error of a record, as a share of its light, above which it gets more
   *     rays
   */
  IndirectPass(
      LightScene scene,
      Solution solution,
      Texels texels,
      NearbyPass nearby,
      float[] direct,
      TexelRays.Sets sets,
      double noise) {
    this.scene = scene;
    this.solution = solution;
    this.texels = texels;
    this.nearby = nearby;
    this.direct = direct;
    this.sets = sets;
    this.noise = noise;
    dark = DARK * meanLight();
    grids = texels.atlas().pages().stream().map(ChartGrid::new).toArray(ChartGrid[]::new);
  }

  long rays() {
    return rays.sum();
  }

  /**
   * Returns the least light that noise is expressed as a share of; red, green and blue together,
   * lx.
   */
  double dark() {
    return dark;
  }

  LightRecords records() {
    return records;
  }

  /** Gathers the records; returns false if the work was cancelled. */
  boolean gather(WorkProgress progress, DoubleConsumer done) {
    for (int level = 0; level < STRIDES.length; level++) {
      int stride = STRIDES[level];
      double before = GATHERED * level / STRIDES.length;
      int[] places = new Thinning(scene, solution, texels).of(wanting(stride, progress), stride);
      if (progress.cancelled()
          || !gather(
              places, stride, progress, d -> done.accept(before + GATHERED * d / STRIDES.length))) {
        return false;
      }
      records.index();
    }
    NoiseRounds rounds =
        new NoiseRounds(scene, solution, texels, nearby, direct, sets, records, noise, dark);
    boolean whole = rounds.run(progress, d -> done.accept(GATHERED + (1 - GATHERED) * d));
    rays.add(rounds.rays());
    return whole;
  }

  /** Returns the texels of a grid that need a record of their own. */
  private int[] wanting(int stride, WorkProgress progress) {
    int[][] byChunk = new int[texels.tiles()][];
    ParallelWork.run(
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
    private final TexelPlace place = new TexelPlace(scene, solution, texels);
    private final RecordReader reader = new RecordReader(records);
    private final int[] list = new int[Texels.TILE * Texels.TILE];
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
  boolean at(RecordReader reader, int texel, TexelPlace place) {
    return reader.at(
        place.point, place.normal, place.flat(), group(place), nearby.reach(texel, place));
  }

  /**
   * Returns the group of a surface point: reference versions and bodies without versions see the
   * same scene, and any other version sees one of its own.
   */
  private int group(TexelPlace place) {
    return scene.versions().isReference(place.version) ? 0 : place.version;
  }

  private static double sum(float[] rgb, int texel) {
    return (double) rgb[3 * texel] + rgb[3 * texel + 1] + rgb[3 * texel + 2];
  }

  private boolean gather(int[] places, int stride, WorkProgress progress, DoubleConsumer done) {
    float[] block = new float[LightRecords.NUMBERS * places.length];
    int[] groups = new int[places.length];
    HitLight hits = new HitLight(scene, solution, texels, direct);
    boolean whole =
        ParallelWork.run(
            places.length,
            64,
            progress,
            done,
            (from, to) -> {
              Hemisphere hemisphere = new Hemisphere(scene, hits, sets);
              TexelPlace place = new TexelPlace(scene, solution, texels);
              LightRecord record = new LightRecord();
              for (int i = from; i < to; i++) {
                place.at(places[i]);
                hemisphere.gather(place, places[i], fewer(stride), record);
                groups[i] = record.seen ? group(place) : -1;
                LightRecords.write(
                    place, radius(record, place, stride), record, block, LightRecords.NUMBERS * i);
              }
              rays.add(hemisphere.rays());
            });
    for (int i = 0; i < places.length && whole; i++) {
      if (groups[i] < 0) {
        texels.leave(places[i]);
      } else {
        records.add(block, LightRecords.NUMBERS * i, groups[i], places[i]);
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

  private static double radius(LightRecord record, TexelPlace place, int stride) {
    double least = (stride == 1 ? LEAST_SINGLE : LEAST) * place.size();
    return Math.max(least, Math.min(MOST * place.size(), REACH * record.distance));
  }
}
