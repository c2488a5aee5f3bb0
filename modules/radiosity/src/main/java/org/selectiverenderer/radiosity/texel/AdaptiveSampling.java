package org.selectiverenderer.radiosity.texel;

import java.util.Arrays;
import java.util.function.DoubleConsumer;
import java.util.stream.IntStream;
import org.selectiverenderer.radiosity.parallel.ParallelFor;
import org.selectiverenderer.radiosity.parallel.RadiosityProgress;

/**
 * Adaptive sampling in rounds: denoises all records and casts more rays for those that keep more
 * noise than requested, the noisiest first, until all are good enough or the rays are used up. The
 * decision uses the error after denoising with the neighbours, not the variance of the record's own
 * rays: that would darken the light, since a record that is too bright by chance also looks noisier
 * (Kirk and Arvo 1991).
 */
final class AdaptiveSampling {
  private static final int ROUNDS = 3;

  /** Number of rays of all rounds, as a share of the first rays. */
  private static final double MORE = 0.5;

  /** Largest distance of records used in denoising, texels. */
  private static final double FARTHEST = 8;

  /** Noise below which the filter need not go, as a share of the requested noise. */
  private static final double ENOUGH = 0.5;

  /** Numbers stored for each record: from its error to its rotational gradient. */
  private static final int KEPT = IrradianceCache.RAYS - IrradianceCache.ERROR;

  private static final int CHUNK = 256;

  private final RecordGatherer gatherer;
  private final TexelOcclusionPass nearby;
  private final float[] direct;
  private final int most;
  private final IrradianceCache records;
  private final double noise;
  private final double dark;
  private final float[] evened;

  /**
   * @param direct the direct light of each texel; r, g, b, lx
   * @param most largest number of further rays of a record in a round
   * @param noise the requested standard error, as a share of the light
   * @param dark least light that relative errors refer to; red, green and blue together, lx
   */
  AdaptiveSampling(
      RecordGatherer gatherer,
      TexelOcclusionPass nearby,
      float[] direct,
      int most,
      IrradianceCache records,
      double noise,
      double dark) {
    this.gatherer = gatherer;
    this.nearby = nearby;
    this.direct = direct;
    this.most = most;
    this.records = records;
    this.noise = noise;
    this.dark = dark;
    evened = new float[KEPT * records.size()];
  }

  /**
   * Runs all rounds; returns false if the work was cancelled, and then the records are unchanged
   * except for further rays.
   */
  boolean run(RadiosityProgress progress, DoubleConsumer done) {
    NeighbourRecordSearch.Places places = new NeighbourRecordSearch.Places(records);
    int[] which = IntStream.range(0, records.size()).toArray();
    double left = 0;
    for (int i = 0; i < records.size(); i++) {
      left += MORE * records.numbers()[IrradianceCache.NUMBERS * i + IrradianceCache.RAYS];
    }
    for (int round = 0; ; round++) {
      double before = (double) round / (ROUNDS + 1);
      if (!filter(places, which, progress)) {
        return false;
      }
      which = round < ROUNDS ? noisy(left) : new int[0];
      if (which.length == 0) {
        break;
      }
      for (int i : which) {
        left -= batch(i);
      }
      if (!gather(which, round, progress, d -> done.accept(before + d / (ROUNDS + 1)))) {
        return false;
      }
    }
    records.even(evened);
    return true;
  }

  private boolean filter(
      NeighbourRecordSearch.Places places, int[] which, RadiosityProgress progress) {
    return ParallelFor.run(
        which.length,
        CHUNK,
        progress,
        share -> {},
        (from, to) -> {
          LepskiDenoiser filter = new LepskiDenoiser(records, places);
          TexelSurfacePoint place = gatherer.place();
          for (int i = from; i < to; i++) {
            int texel = records.texels()[which[i]];
            place.at(texel);
            double reach = nearby.reach(texel, place);
            double farthest = FARTHEST * place.size();
            filter.filter(which[i], reach, farthest, ENOUGH * noise * light(which[i]));
            keep(which[i], filter.out);
          }
        });
  }

  private void keep(int record, IrradianceRecord out) {
    int at = KEPT * record;
    evened[at] = (float) out.error;
    for (int c = 0; c < 3; c++) {
      evened[at + IrradianceCache.LIGHT - IrradianceCache.ERROR + c] = (float) out.light[c];
    }
    for (int k = 0; k < 9; k++) {
      evened[at + IrradianceCache.TURN - IrradianceCache.ERROR + k] = (float) out.turn[k];
    }
  }

  /** Returns the irradiance at a record before denoising, red, green and blue together. */
  private double light(int record) {
    float[] all = records.numbers();
    int at = IrradianceCache.NUMBERS * record + IrradianceCache.LIGHT;
    return light(record, all, at);
  }

  private double light(int record, float[] from, int at) {
    int texel = 3 * records.texels()[record];
    double lamps = (double) direct[texel] + direct[texel + 1] + direct[texel + 2];
    return Math.max(dark, lamps + from[at] + from[at + 1] + from[at + 2]);
  }

  private double share(int record) {
    int at = KEPT * record;
    return evened[at] / light(record, evened, at + IrradianceCache.LIGHT - IrradianceCache.ERROR);
  }

  /**
   * Returns the number of rays that a record gets in a round: as many as it has, up to all of a
   * set.
   */
  private int batch(int record) {
    double has = records.numbers()[IrradianceCache.NUMBERS * record + IrradianceCache.RAYS];
    return (int) Math.min(most, has);
  }

  /** Returns the records that get more rays within the number left, chosen noisiest first. */
  private int[] noisy(double left) {
    // Sort key: the inverted bits of the share, which is above 0, so that larger shares come first,
    // then the record's number.
    long[] all =
        IntStream.range(0, records.size())
            .filter(i -> share(i) > noise)
            .mapToLong(i -> (long) ~Float.floatToIntBits((float) share(i)) << 32 | i)
            .sorted()
            .toArray();
    int count = 0;
    double sum = 0;
    while (count < all.length && sum + batch((int) all[count]) <= left) {
      sum += batch((int) all[count++]);
    }
    return Arrays.stream(all, 0, count).mapToInt(key -> (int) key).sorted().toArray();
  }

  private boolean gather(int[] which, int round, RadiosityProgress progress, DoubleConsumer done) {
    int[] at = IntStream.of(which).map(i -> records.texels()[i]).toArray();
    return gatherer.gather(
        at,
        progress,
        done,
        (i, place, hemisphere, more) -> {
          int fewer = Math.max(1, most / batch(which[i]));
          hemisphere.gather(place, at[i] + 0x3779b97f * (round + 1), fewer, more);
          records.join(which[i], more);
        });
  }
}
