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
  },
  /** Apartments of the thesis, all inlined from the same file; the walk goes through the first. */
  STREET(1, 16, 64, 256, 1_024) {
    @Override
    public BenchScene write(Path dir, int size) throws IOException {
      return StreetSceneGenerator.write(dir, size);
    }

    @Override
    public List<Integer> usualSizes() {
      return sizes().subList(0, sizes().size() - 1);
    }

    @Override
    public boolean sharesFiles() {
      return true;
    }

    @Override
    public int secondsDrawn() {
      return 10;
    }
  },
  /** Houses of the heavy scene, each with 70 objects of its own shapes; all files differ. */
  MODELS(1, 4, 13) {
    @Override
    public BenchScene write(Path dir, int size) throws IOException {
      return HousesSceneGenerator.write(dir, size, 1);
    }

    @Override
    public int secondsDrawn() {
      return 5;
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

  /** Returns the sizes that are measured when all series are, which leaves out very large ones. */
  public List<Integer> usualSizes() {
    return sizes();
  }

  /** Returns whether the scenes of the series are written into one folder, for common files. */
  public boolean sharesFiles() {
    return false;
  }

  /** Returns the duration of the drawn run in seconds of the path's time, of 60 frames each. */
  public int secondsDrawn() {
    return 1;
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
