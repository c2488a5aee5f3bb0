package org.selectiverenderer.bench.measure;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.stream.Stream;
import org.selectiverenderer.base.decimal.DecimalRounding;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.read.X3dReader;

/**
 * Measures the reading of all files of a scene on all processors, from memory, so that the disk has
 * no influence.
 */
final class ReadingMeasurement {
  /**
   * The number of rounds: the first is the cold result, the median of the second half the warm one.
   */
  private static final int ROUNDS = 12;

  private ReadingMeasurement() {}

  static void measure(Path folder, ObjectNode node) throws IOException, InterruptedException {
    List<byte[]> files = files(folder);
    double megabytes = files.stream().mapToLong(file -> file.length).sum() / 1e6;
    X3dReader reader = new X3dReader(NodeCatalogue.load());
    double[] seconds = new double[ROUNDS];
    ExecutorService threads =
        Executors.newFixedThreadPool(
            Runtime.getRuntime().availableProcessors(), task -> new Thread(task, "bench-reader"));
    try {
      for (int round = 0; round < ROUNDS; round++) {
        long begun = System.nanoTime();
        read(files, reader, threads);
        seconds[round] = (System.nanoTime() - begun) * 1e-9;
      }
    } finally {
      threads.shutdownNow();
    }
    double[] warm = Arrays.copyOfRange(seconds, ROUNDS / 2, ROUNDS);
    Arrays.sort(warm);
    node.put("mb", DecimalRounding.to(1, megabytes));
    node.put("mb_per_s", DecimalRounding.to(1, megabytes / warm[warm.length / 2]));
    node.put("cold_mb_per_s", DecimalRounding.to(1, megabytes / seconds[0]));
  }

  private static List<byte[]> files(Path folder) throws IOException {
    try (Stream<Path> paths = Files.walk(folder)) {
      List<byte[]> files = new ArrayList<>();
      for (Path path : paths.filter(p -> p.toString().endsWith(".x3d")).sorted().toList()) {
        files.add(Files.readAllBytes(path));
      }
      return files;
    }
  }

  private static void read(List<byte[]> files, X3dReader reader, ExecutorService threads)
      throws IOException, InterruptedException {
    List<Callable<Integer>> tasks = new ArrayList<>();
    for (byte[] file : files) {
      tasks.add(
          () ->
              reader
                  .read("bench", new ByteArrayInputStream(file), new ProblemCollector())
                  .nodes()
                  .size());
    }
    for (Future<Integer> task : threads.invokeAll(tasks)) {
      try {
        if (task.get() == 0) {
          throw new IOException("a file of the benchmark's scene holds no nodes");
        }
      } catch (ExecutionException e) {
        throw new IOException("a file of the benchmark's scene cannot be read", e);
      }
    }
  }
}
