package org.selectiverenderer.bench;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;

/**
 * Series of scenes of growing size: one kind of thing grows in number and everything else stays
 * constant, so that a curve shows its cost. The same size gives the same bytes.
 */
public enum GrowthSeries {
  /** Objects in one file, that share the same number of triangles. */
  OBJECTS(10, 100, 1_000, 10_000) {
    @Override
    public BenchScene write(Path dir, int size) throws IOException {
      return GrowthSceneGenerator.objects(dir, size, false);
    }
  },
  /** ProximitySensors, of which the viewer is near a few. */
  SENSORS(1, 10, 100, 1_000, 10_000, 100_000) {
    @Override
    public BenchScene write(Path dir, int size) throws IOException {
      return GrowthSceneGenerator.sensors(dir, size);
    }
  },
  /** Enriched Switches, of which ten change. */
  SWITCHES(10, 100, 1_000, 10_000, 100_000) {
    @Override
    public BenchScene write(Path dir, int size) throws IOException {
      return ManySwitchesSceneGenerator.write(dir, size, GrowthSceneGenerator.SWITCHES);
    }
  },
  /** Objects in files of their own, that share the same number of triangles. */
  INLINES(100, 1_000, 10_000) {
    @Override
    public BenchScene write(Path dir, int size) throws IOException {
      return GrowthSceneGenerator.objects(dir, size, true);
    }
  },
  /** Triangles, in ten inlined files. */
  TRIANGLES(100_000, 1_000_000, 10_000_000) {
    @Override
    public BenchScene write(Path dir, int size) throws IOException {
      int columns = (int) Math.round(Math.sqrt(size / 20.0));
      return GrowthSceneGenerator.objects(dir, FILES, size / 20 / columns, columns, true);
    }
  };

  private static final int FILES = 10;

  private final List<Integer> sizes;

  GrowthSeries(Integer... sizes) {
    this.sizes = List.of(sizes);
  }

  /** Returns the sizes of the scenes, ascending. */
  public List<Integer> sizes() {
    return sizes;
  }

  /**
   * Writes a scene and a path through it that enters a few areas.
   *
   * @param dir created if it does not exist
   * @param size one of {@link #sizes()}
   * @throws IOException when a file cannot be written
   */
  public abstract BenchScene write(Path dir, int size) throws IOException;
}
