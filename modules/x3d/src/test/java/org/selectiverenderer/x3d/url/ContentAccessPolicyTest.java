package org.selectiverenderer.x3d.url;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.testing.RequiresSymbolicLinks;
import org.selectiverenderer.x3d.url.UrlResolver.Cause;
import org.selectiverenderer.x3d.url.UrlResolver.Target;

/** What a scene may name beyond its own folder. */
class ContentAccessPolicyTest {
  @TempDir private Path top;
  private Path project;
  private Path scenes;

  @BeforeEach
  void files() throws IOException {
    project = Files.createDirectories(top.resolve("home/work/project"));
    scenes = Files.createDirectories(project.resolve("models/scenes"));
    for (String file : List.of("images/wood.png", "models/desk.x3d", ".hidden/key", "../b.x3d")) {
      Path path = project.resolve(file).normalize();
      Files.createDirectories(path.getParent());
      Files.writeString(path, file);
    }
  }

  private Target resolve(String url, Path... allowed) {
    ContentAccessPolicy access = new ContentAccessPolicy(List.of(allowed), HttpFetcher.none());
    return new UrlResolver(scenes, access, top.resolve("home"))
        .resolve(url, BaseUrl.folder(scenes));
  }

  private static void assertRead(Target target, String content) throws IOException {
    assertThat(target).isInstanceOf(Target.Found.class);
    assertThat(((Target.Found) target).content().bytes(1000)).asString(UTF_8).isEqualTo(content);
  }

  private static void assertOutside(Target target) {
    assertThat(target)
        .isInstanceOfSatisfying(
            Target.Refused.class, refused -> assertThat(refused.cause()).isEqualTo(Cause.OUTSIDE));
  }

  @Test
  void withoutAMarkerOnlyTheScenesOwnFolderIsOpen() {
    assertOutside(resolve("../../images/wood.png"));
    assertOutside(resolve("../desk.x3d"));
  }

  @ParameterizedTest
  @ValueSource(strings = {".git", "x3d-project"})
  void aMarkerOpensTheTreeBelowIt(String marker) throws IOException {
    Files.writeString(project.resolve(marker), "");
    assertRead(resolve("../../images/wood.png"), "images/wood.png");
    assertRead(resolve("../desk.x3d"), "models/desk.x3d");
    assertOutside(resolve("../../../b.x3d"));
  }

  @Test
  void theNearestMarkerCounts() throws IOException {
    Files.writeString(project.resolve("x3d-project"), "");
    Files.createDirectory(project.resolve("models/.git"));
    assertRead(resolve("../desk.x3d"), "models/desk.x3d");
    assertOutside(resolve("../../images/wood.png"));
  }

  @Test
  void whatBeginsWithADotIsNotOpenedByAMarker() throws IOException {
    Files.createDirectory(project.resolve(".git"));
    Files.writeString(project.resolve(".git/config"), "");
    assertOutside(resolve("../../.hidden/key"));
    assertOutside(resolve("../../.git/config"));
  }

  @Test
  void whatBeginsWithADotBelowTheScenesFolderIsNotOpened() throws IOException {
    for (String file : List.of(".git/config", "lib/.venv/a.js", "plain.js")) {
      Path path = scenes.resolve(file);
      Files.createDirectories(path.getParent());
      Files.writeString(path, file);
    }
    Files.createDirectories(scenes.resolveSibling("inlineNodes/.git"));
    Files.writeString(scenes.resolveSibling("inlineNodes/.git/config"), "");
    assertRead(resolve("plain.js"), "plain.js");
    assertOutside(resolve(".git/config"));
    assertOutside(resolve("lib/.venv/a.js"));
    assertOutside(resolve("../inlineNodes/.git/config"));
    assertRead(resolve(".git/config", scenes.resolve(".git")), ".git/config");
  }

  @Test
  @RequiresSymbolicLinks
  void aLinkToWhatBeginsWithADotIsNotFollowed() throws IOException {
    Files.createDirectory(scenes.resolve(".git"));
    Files.writeString(scenes.resolve(".git/config"), "");
    Files.createSymbolicLink(scenes.resolve("g"), scenes.resolve(".git"));
    assertOutside(resolve("g/config"));
  }

  @Test
  void aUsersHomeIsNoProjectAndNorIsWhatIsAboveIt() throws IOException {
    Files.createDirectory(top.resolve("home/.git"));
    Files.createDirectory(top.resolve(".git"));
    assertOutside(resolve("../../images/wood.png"));
  }

  @Test
  void aSceneInTheHomeMayNotNameWhatIsHiddenThere() throws IOException {
    Path home = top.resolve("home");
    Files.createDirectories(home.resolve(".ssh"));
    Files.writeString(home.resolve(".ssh/id"), "");
    Files.writeString(home.resolve("a.x3d"), "a");
    UrlResolver root = new UrlResolver(home, ContentAccessPolicy.none(), home);
    assertRead(root.resolve("a.x3d", home), "a");
    assertRead(root.resolve("work/b.x3d", home), "../b.x3d");
    assertOutside(root.resolve(".ssh/id", home));
  }

  @Test
  @RequiresSymbolicLinks
  void linksDoNotLeadOutOfAProject() throws IOException {
    Files.writeString(project.resolve("x3d-project"), "");
    Files.createSymbolicLink(project.resolve("images/out.x3d"), project.resolve("../b.x3d"));
    assertOutside(resolve("../../images/out.x3d"));
  }

  @Test
  void anAllowedFolderIsOpenAndARefusalNamesIt() throws IOException {
    Target.Refused refused = (Target.Refused) resolve("../../images/wood.png");
    String hint = refused.reason().replaceAll(".*--allow (.*) would allow it", "$1");
    assertThat(Path.of(hint).toRealPath()).isEqualTo(project.resolve("images").toRealPath());
    assertRead(resolve("../../images/wood.png", Path.of(hint)), "images/wood.png");
    assertRead(resolve("../../.hidden/key", project.resolve(".hidden")), ".hidden/key");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "data:text/plain;charset=utf-8,a%20b+c%2|a b+c%2",
        "data:;base64,aGVs bG8=|hello",
        "DATA:,x#Name|x",
        "data:model/vrml,#VRML V2.0 utf8 Group{}|#VRML V2.0 utf8 Group{}",
        "data:model/x3d+vrml,#X3D V3.3 utf8|#X3D V3.3 utf8",
        "data:text/plain;BASE64,aGVs%62G8=|hello",
      })
  void dataIsInTheUrl(String url, String content) throws IOException {
    Target target = resolve(url);
    assertRead(target, content);
    assertThat(((Target.Found) target).fragment()).isEqualTo(url.endsWith("#Name") ? "Name" : "");
  }

  @Test
  void theNameOfDataIsOneLine() {
    Target target = resolve("data:text/plain,\n  a\r\nb");
    assertThat(((Target.Found) target).content().name()).isEqualTo("data:text/plain,   a b");
  }

  @Test
  void damagedDataIsRefused() {
    assertThat(((Target.Refused) resolve("data:text/plain")).reason()).contains("comma");
    assertThat(((Target.Refused) resolve("data:;base64,a")).reason()).contains("base64");
  }

  @Test
  void aPrototypesBodyMayMeanFilesOfEitherPlace() throws IOException {
    UrlResolver root = new UrlResolver(project, ContentAccessPolicy.none(), top);
    BaseUrl both = BaseUrl.folder(project.resolve("models")).or(BaseUrl.folder(project));
    assertRead(root.resolve("desk.x3d", both), "models/desk.x3d");
    assertRead(root.resolve("images/wood.png", both), "images/wood.png");
    assertThat(((Target.Refused) root.resolve("none.png", both)).cause()).isEqualTo(Cause.MISSING);
  }

  @Test
  void hostsAreNamedExactlyOrByTheirDomain() {
    assertThat(matches("Example.org", "http://example.ORG/a")).isTrue();
    assertThat(matches("example.org", "http://www.example.org/a")).isFalse();
    assertThat(matches("*.example.org", "http://www.example.org/a")).isTrue();
    assertThat(matches("*.example.org", "http://example.org/a")).isFalse();
    assertThat(matches("*.example.org", "http://badexample.org/a")).isFalse();
    assertThat(matches("example.org", "https://example.org:80/a")).isTrue();
    assertThat(matches("example.org", "http://example.org:8080/a")).isFalse();
    assertThat(matches("example.org:8080", "http://example.org:8080/a")).isTrue();
    assertThat(matches("example.org:8080", "http://example.org/a")).isFalse();
    assertThat(matches("*.example.org:8080", "https://a.example.org:8080/")).isTrue();
    assertThat(matches("[::1]:8080", "http://[::1]:8080/")).isTrue();
    for (String wrong : List.of("https://example.org", "*", "example.org/a", "", "*.*.org")) {
      assertThatThrownBy(() -> new HostPattern(wrong))
          .isInstanceOf(IllegalArgumentException.class)
          .hasMessageContaining("is no host");
    }
  }

  private static boolean matches(String pattern, String url) {
    return new HostPattern(pattern).matches(URI.create(url));
  }
}
