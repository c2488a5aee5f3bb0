package org.selectiverenderer.radiosity.reference;

import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.concurrent.atomic.LongAdder;
import java.util.stream.IntStream;
import org.selectiverenderer.radiosity.scene.RadiosityScene;
import org.selectiverenderer.radiosity.trace.Ray;

/**
 * The path-traced light of a picture, pass after pass. Each pixel of each pass has random numbers
 * of its own, and sums are added in the order of the passes, so the result depends neither on the
 * number of threads nor on where the work was stopped and gone on with.
 */
final class ReferenceImage {
  /** Paths from each place in a pass. */
  static final int PATHS = 16;

  private static final int FORM = 0x53523101;

  /**
   * Steps of a sequence that fills a cube evenly (Roberts 2018, "The Unreasonable Effectiveness of
   * Quasirandom Sequences"): powers of the root of x^4 = x + 1, and of x^3 = x + 1 for a square.
   */
  private static final double[] CUBE = {0.8191725133961645, 0.6710436067037893, 0.5497004779019703};

  private static final double[] SQUARE = {0.7548776662466927, 0.5698402909980532};

  private final RadiosityScene scene;
  private final SceneEmitters lights;
  private final PrimaryHits hits;
  private final int seed;

  /** Sums of even and odd passes: two pictures with noise of their own. */
  private final double[][] sums;

  private int passes;
  private final LongAdder rays = new LongAdder();

  ReferenceImage(RadiosityScene scene, PrimaryHits hits, int seed) {
    this.scene = scene;
    this.hits = hits;
    this.seed = seed;
    lights = new SceneEmitters(scene);
    sums = new double[2][3 * hits.pixels()];
  }

  /** Paths through each pixel so far. */
  long samples() {
    return (long) passes * PATHS * hits.places();
  }

  long rays() {
    return rays.sum();
  }

  /** Follows {@link #PATHS} more paths from every place of every pixel. */
  void pass() {
    double[] sum = sums[passes % 2];
    IntStream.range(0, hits.height())
        .parallel()
        .forEach(
            row -> {
              PathTracer tracer = new PathTracer(scene, lights);
              double[] own = new double[3];
              for (int pixel = row * hits.width(); pixel < (row + 1) * hits.width(); pixel++) {
                Arrays.fill(own, 0);
                pixel(pixel, tracer, own);
                for (int c = 0; c < 3; c++) {
                  sum[3 * pixel + c] += own[c] / PATHS / hits.places();
                }
              }
              rays.add(tracer.rays());
            });
    passes++;
  }

  private void pixel(int pixel, PathTracer tracer, double[] sum) {
    SplittableRandom random =
        new SplittableRandom(((long) seed << 48) ^ ((long) passes << 32) ^ pixel);
    double[] lamp = {random.nextDouble(), random.nextDouble(), random.nextDouble()};
    double[] way = {random.nextDouble(), random.nextDouble()};
    int number = 0;
    for (int place = pixel * hits.places(); place < (pixel + 1) * hits.places(); place++) {
      if (hits.triangle()[place] == Ray.NOTHING) {
        continue;
      }
      for (int path = 0; path < PATHS; path++) {
        // The first step of all paths of a pixel is spread evenly, each time at another place.
        PathTracer.First first =
            new PathTracer.First(
                turned(lamp[0], number * CUBE[0]),
                turned(lamp[1], number * CUBE[1]),
                turned(lamp[2], number * CUBE[2]),
                turned(way[0], number * SQUARE[0]),
                turned(way[1], number * SQUARE[1]));
        number++;
        tracer.add(
            hits.triangle()[place],
            hits.u()[place],
            hits.v()[place],
            hits.behind()[place],
            false,
            first,
            random,
            sum);
      }
    }
  }

  private static double turned(double start, double steps) {
    double sum = start + steps;
    return sum - Math.floor(sum);
  }

  /** Reflected radiance r, g, b per pixel, cd/m2, the background black. */
  double[] light() {
    double[] all = new double[sums[0].length];
    for (int i = 0; i < all.length; i++) {
      all[i] = (sums[0][i] + sums[1][i]) / passes;
    }
    return all;
  }

  /** The same from half of the passes; needs two passes. */
  double[] half(int which) {
    int count = which == 0 ? (passes + 1) / 2 : passes / 2;
    return Arrays.stream(sums[which]).map(value -> value / count).toArray();
  }

  /** Writes the sums, so that another run can go on. */
  void save(Path file) throws IOException {
    Path part = file.resolveSibling(file.getFileName() + ".part");
    try (DataOutputStream out =
        new DataOutputStream(new BufferedOutputStream(Files.newOutputStream(part)))) {
      out.writeInt(FORM);
      out.writeLong(key());
      out.writeInt(passes);
      for (double[] half : sums) {
        for (double value : half) {
          out.writeDouble(value);
        }
      }
    }
    Files.move(part, file, StandardCopyOption.REPLACE_EXISTING);
  }

  /**
   * Goes on with what was saved.
   *
   * @throws IOException if it cannot be read, or belongs to another scene, view, size or seed
   */
  void load(Path file) throws IOException {
    try (DataInputStream in =
        new DataInputStream(new BufferedInputStream(Files.newInputStream(file)))) {
      if (in.readInt() != FORM || in.readLong() != key()) {
        throw new IOException(
            file
                + ": these sums are of another scene, view, size or seed; delete the file to begin"
                + " anew");
      }
      passes = in.readInt();
      for (double[] half : sums) {
        for (int i = 0; i < half.length; i++) {
          half[i] = in.readDouble();
        }
      }
    }
  }

  /** What the sums are of. */
  private long key() {
    long key = 31L * (31L * seed + hits.width()) + hits.side();
    key = 31 * key + Arrays.hashCode(scene.triangles().corners());
    key = 31 * key + Arrays.hashCode(hits.triangle());
    key = 31 * key + Arrays.hashCode(hits.u());
    for (var body : scene.bodies()) {
      key = 31 * key + Arrays.hashCode(body.reflectance());
      key = 31 * key + Arrays.hashCode(body.emission());
    }
    return 31 * key + Double.hashCode(scene.lumens());
  }
}
