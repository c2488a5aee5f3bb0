package org.selectiverenderer.render;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import org.joml.Vector3d;
import org.selectiverenderer.bench.BenchScene;
import org.selectiverenderer.bench.HeavySceneGenerator;
import org.selectiverenderer.browser.camera.Camera;
import org.selectiverenderer.browser.camera.DepthRange;
import org.selectiverenderer.browser.instance.Background;
import org.selectiverenderer.browser.viewer.Viewer;
import org.selectiverenderer.render.context.OffscreenContext;
import org.selectiverenderer.render.context.OffscreenFramebuffer;
import org.selectiverenderer.render.display.FrameTimeStatistics;
import org.selectiverenderer.render.draw.SceneRenderer;
import org.selectiverenderer.render.draw.VisibleSet;

/** Measures frames of the heavy scene along its path; run by hand, prints one line per round. */
public final class HeavySceneBenchmark {
  private HeavySceneBenchmark() {}

  public static void main(String[] args) throws IOException {
    int samples = args.length > 0 ? Integer.parseInt(args[0]) : 0;
    double share = args.length > 1 ? Double.parseDouble(args[1]) : 1;
    Path dir = Path.of(System.getProperty("java.io.tmpdir"), "heavy-" + share);
    Path file = dir.resolve("scene.x3d");
    if (!Files.exists(file)) {
      BenchScene written = HeavySceneGenerator.write(dir, share);
      file = written.scene();
    }
    List<double[]> path =
        Files.readAllLines(dir.resolve("bench-path.csv")).stream()
            .skip(1)
            .map(line -> Arrays.stream(line.split(",")).mapToDouble(Double::parseDouble).toArray())
            .toList();
    TestScene scene = TestScene.load(file);
    try (OffscreenContext context = OffscreenContext.open()) {
      OffscreenFramebuffer target = new OffscreenFramebuffer(context.gl(), 1024, 768, samples);
      SceneRenderer renderer = new SceneRenderer(2, ShadingMode.AUTO);
      System.out.println(context.info() + " samples " + target.samples());
      long start = System.nanoTime();
      renderer.prepare(context.gl(), scene.tree());
      context.gl().glFinish();
      System.out.printf("upload %.0f ms%n", (System.nanoTime() - start) / 1e6);
      for (int round = 0; round < 3; round++) {
        FrameTimeStatistics times = new FrameTimeStatistics(1000);
        double[] cpu = cpu();
        long culling = 0;
        long triangles = 0;
        int frames = 150;
        for (int frame = 0; frame < frames; frame++) {
          double[] pose = path.get(frame * (path.size() - 1) / frames);
          Viewer viewer = new Viewer();
          viewer.moveTo(new Vector3d(pose[1], pose[2], pose[3]));
          if (pose.length > 4) {
            viewer.turnTo(
                Viewer.orientation(
                    Math.toRadians(pose[4]), Math.toRadians(pose[5]), Math.toRadians(pose[6])));
          }
          long before = System.nanoTime();
          target.bind(context.gl());
          DepthRange range = DepthRange.of(scene.tree(), viewer.position(), 0.25, 0);
          Camera camera = Camera.of(viewer, 1024, 768, range.near(), range.far());
          renderer.prepare(context.gl(), scene.tree());
          VisibleSet seen = renderer.cull(context.gl(), List.of(camera));
          culling += System.nanoTime() - before;
          triangles += seen.indices() / 3;
          renderer.draw(context.gl(), seen, camera, Background.BLACK, false);
          target.finish(context.gl());
          times.add((System.nanoTime() - before) / 1e6);
          if (round == 0 && frame % 50 == 0) {
            target.read(context.gl()).writePng(dir.resolve("frame" + frame + ".png"));
          }
        }
        double[] after = cpu();
        System.out.printf(
            "%.1f fps, CPU ms per frame: this thread %.1f, rasteriser %.1f; %s; cull %.2f ms;"
                + " %d triangles%n",
            1000 / times.summary().mean(),
            (after[0] - cpu[0]) / frames,
            (after[1] - cpu[1]) / frames,
            times.summary(),
            culling / 1e6 / frames,
            triangles / frames);
      }
      renderer.dispose(context.gl());
      target.dispose(context.gl());
    }
  }

  /** CPU milliseconds so far of this thread and of llvmpipe's; Linux only. */
  private static double[] cpu() throws IOException {
    double rasteriser = 0;
    try (var tasks = Files.list(Path.of("/proc/self/task"))) {
      for (Path task : tasks.toList()) {
        String stat = Files.readString(task.resolve("stat"));
        String[] fields = stat.substring(stat.lastIndexOf(')') + 2).split(" ");
        if (stat.contains("(llvmpipe")) {
          rasteriser += 10 * (Double.parseDouble(fields[11]) + Double.parseDouble(fields[12]));
        }
      }
    }
    long own = ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
    return new double[] {own / 1e6, rasteriser};
  }
}
