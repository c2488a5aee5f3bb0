package org.selectiverenderer.bench;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Warmup;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.read.X3dFile;
import org.selectiverenderer.x3d.read.X3dReader;

/**
 * Time to read all files of a scene of the thesis's size, 32.7 MB of text. As it stands it measures
 * a warm JVM; {@code -bm ss -wi 0 -i 1 -f 5} measures the first read of a fresh one.
 */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 3, time = 2)
@Fork(1)
public class ReadBenchmark {
  @Param({"1", "4"})
  int threads;

  private List<byte[]> files = List.of();
  private ExecutorService pool = Executors.newSingleThreadExecutor();

  @Setup(Level.Trial)
  public void generate() {
    files = GeneratedScenes.thesisSize();
    pool.shutdown();
    pool = Executors.newFixedThreadPool(threads);
  }

  @TearDown(Level.Trial)
  public void stop() {
    pool.shutdown();
  }

  @Benchmark
  public List<X3dFile> read() throws InterruptedException, ExecutionException {
    X3dReader reader = new X3dReader(NodeCatalogue.load());
    ProblemCollector problems = new ProblemCollector();
    List<Future<X3dFile>> reads = new ArrayList<>();
    for (byte[] file : files) {
      reads.add(pool.submit(() -> reader.read("object.x3d", file, problems)));
    }
    List<X3dFile> scenes = new ArrayList<>();
    for (Future<X3dFile> read : reads) {
      scenes.add(read.get());
    }
    if (problems.any()) {
      throw new IllegalStateException("the generated scene is not valid: " + problems.list());
    }
    return scenes;
  }
}
