package org.selectiverenderer.x3d.url;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.read.X3dReader;

class UrlResolverTest {
  @TempDir private Path folder;

  private UrlResolver.Target resolve(String url) {
    return new UrlResolver(folder).resolve(url, folder);
  }

  private String refusal(String url) {
    return resolve(url) instanceof UrlResolver.Target.Refused refused ? refused.reason() : "none";
  }

  @Test
  void aUrlLongerThanAFileNameIsRefused() {
    assertThat(refusal("a/".repeat(60_000) + "b.x3d")).isEqualTo("is too long for a file name");
    assertThat(refusal("a/".repeat(2000) + "b.x3d")).startsWith("is missing");
  }

  @Test
  void messagesShowTheBeginningOfALongUrl() {
    String scene = "<X3D version='4.0'><Scene><Inline url='%s'/></Scene></X3D>";
    ParsedNode inline =
        new X3dReader(NodeCatalogue.load())
            .read("a.x3d", scene.formatted("a/".repeat(60)).getBytes(UTF_8), new ProblemCollector())
            .nodes()
            .get(0);
    ResolvedUrlContent choice =
        ResolvedUrlContent.of(inline, new UrlResolver(folder), folder, "it is left out");
    assertThat(((ResolvedUrlContent.None) choice).problem().message())
        .isEqualTo("Inline url '" + "a/".repeat(40) + "…' is missing; it is left out");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "//host/share/a.x3d",
        "\\\\host\\share\\a.x3d",
        "/\\host/share/a.x3d",
        "%5C%5Chost/share/a.x3d",
        "file://host/share/a.x3d",
        "file:////host/share/a.x3d",
        "http://host/a.x3d"
      })
  void otherComputersAreNotCalled(String url) {
    assertThat(refusal(url)).startsWith("is on the network");
  }

  @Test
  void aSignPercentThatBeginsNoCodeIsPartOfTheName() throws IOException {
    Files.writeString(folder.resolve("100%.x3d"), "");
    assertThat(resolve("100%.x3d")).isInstanceOf(UrlResolver.Target.Found.class);
    assertThat(refusal("50%.x3d")).isEqualTo("is missing");
  }
}
