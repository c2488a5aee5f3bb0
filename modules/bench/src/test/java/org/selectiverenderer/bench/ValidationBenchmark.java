package org.selectiverenderer.bench;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;
import org.selectiverenderer.validation.SourceFile;
import org.selectiverenderer.validation.ValidationReport;
import org.selectiverenderer.validation.ValidationSettings;
import org.selectiverenderer.validation.run.RuleCatalogue;
import org.selectiverenderer.validation.run.Validator;

/** Time to validate files of the thesis's size, 32.7 MB of text that is in memory. */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 3, time = 2)
@Fork(1)
public class ValidationBenchmark {
  private List<SourceFile> files = List.of();

  @Setup(Level.Trial)
  public void generate() {
    List<byte[]> contents = GeneratedScenes.thesisSize();
    files =
        contents.stream()
            .map(
                content -> {
                  String name = "object-" + contents.indexOf(content) + ".x3d";
                  return SourceFile.of(Path.of(name), name, content);
                })
            .toList();
  }

  @Benchmark
  public ValidationReport validate() throws IOException {
    return new Validator(RuleCatalogue.standard(), ValidationSettings.standard(), Path.of(""))
        .validate(files);
  }
}
