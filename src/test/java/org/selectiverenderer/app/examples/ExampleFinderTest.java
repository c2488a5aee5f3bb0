package org.selectiverenderer.app.examples;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.app.recent.RecentPaths;

class ExampleFinderTest {
  @TempDir Path folder;

  @Test
  void anExampleIsFoundHereThenInTheUsersCopy() throws IOException {
    Path settings = folder.resolve("settings");
    Path copy = Files.createDirectories(folder.resolve("copy/scenes"));
    Files.writeString(copy.resolve("only-there.x3d"), "");
    ExampleFinder finder = new ExampleFinder(settings);
    List<String> wanted = List.of("scenes/no.x3d", "scenes/only-there.x3d");
    assertThat(finder.find(wanted)).isEmpty();
    RecentPaths.exampleFolders(settings).add(folder.resolve("copy"));
    assertThat(finder.find(wanted)).contains(copy.resolve("only-there.x3d"));
    assertThat(finder.find(List.of("scenes/hello.x3d"))).contains(Path.of("scenes/hello.x3d"));
  }
}
