package org.selectiverenderer.study.definition;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Base64;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.trust.PermissionRequests;
import org.selectiverenderer.study.session.LoadedStudy;
import org.selectiverenderer.testing.RequiresSymbolicLinks;

/** What a study asks for beyond its own folder. */
class StudyPermissionsTest {
  private static final String SCENE =
      "<X3D version='4.0' profile='Immersive'><Scene><Viewpoint DEF='Here'/></Scene></X3D>";
  private static final String PAGE =
      "{\"name\": \"own\", \"pages\": [{\"text\": \"Hello\", \"picture\": \"%s\"}]}";
  private static final byte[] PNG =
      Base64.getDecoder()
          .decode(
              "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVR4nGP4//8/AAX+Av4N"
                  + "70a4AAAAAElFTkSuQmCC");

  @TempDir private Path top;
  private Path folder;
  private String top1 = "";
  private final ProblemCollector problems = new ProblemCollector();

  @BeforeEach
  void files() throws IOException {
    folder = Files.createDirectories(top.resolve("sent"));
    top1 = top.toRealPath().toString();
    for (Path place : List.of(top, folder)) {
      Files.writeString(place.resolve("a.x3d"), SCENE);
      Files.writeString(place.resolve("own.json"), PAGE.formatted("p.png"));
      Files.writeString(place.resolve("items.csv"), "area,object,consistency,present,en\n");
      Files.writeString(place.resolve("wide.json"), "{}");
      Files.write(place.resolve("p.png"), PNG);
    }
  }

  private PermissionRequests asked(String keys) throws IOException {
    return StudyPermissions.of(read(keys));
  }

  private Study read(String keys) throws IOException {
    Path file = write(keys);
    Optional<Study> study = StudyReader.read(file, problems);
    assertThat(study).as(problems.list().toString()).isPresent();
    return study.orElseThrow();
  }

  private Path write(String keys) throws IOException {
    return Files.writeString(
        folder.resolve("study.json"),
        """
        {"name": "Sent", "conditions": ["high"], "participants": 4,
         "practice": {"scene": "a.x3d"}, %s}
        """
            .formatted(
                keys.contains("questionnaires")
                    ? keys
                    : keys + ", \"questionnaires\": [{\"template\": \"sus\"}]"));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "'scene': '../a.x3d' | scene TOP/a.x3d",
        "'practice': {'scene': '../a.x3d'} | practice TOP/a.x3d",
        "'form': '../own.json' | form TOP/own.json",
        "'questionnaires': [{'file': '../own.json'}] | file TOP/own.json",
        "'questionnaires': [{'kind': 'recognition', 'items': '../items.csv'}] | items TOP/items.csv",
        "'display': {'hmd': '../wide.json'} | hmd TOP/wide.json",
        "'allow': ['..'] | allow TOP",
        "'allow': ['/'] | allow ROOT",
        "'allowNet': ['example.org:8080'] | allowNet example.org:8080",
        "'tracker': 'tcp:10.0.0.1:25' | tracker tcp:10.0.0.1:25",
        "'tracker': 'vrpn:T@host:3883' | tracker vrpn:T@host:3883",
        "'tracker': 'opentrack:4242' | tracker opentrack:4242",
        "'tracker': 'fastrak:/dev/ttyS0' | tracker fastrak:/dev/ttyS0@9600",
        "'tracker': 'intertrax2:auto' | tracker intertrax2:auto",
        "'streams': {'lsl': true} | lsl send",
        "'streams': {'record': ['x=1']} | record x=1",
      })
  void eachKeyThatReachesOutsideIsARequest(String keys, String request) throws IOException {
    // A second key of one name would be a fault, so the practice is written only once.
    String json = keys.replace('\'', '"');
    Path file = write(json);
    if (json.contains("practice")) {
      Files.writeString(
          file, Files.readString(file).replace("\"practice\": {\"scene\": \"a.x3d\"}, ", ""));
    }
    Optional<Study> study = StudyReader.read(file, problems);
    assertThat(study).as(problems.list().toString()).isPresent();
    assertThat(StudyPermissions.of(study.orElseThrow()).list())
        .extracting(each -> each.key() + " " + each.target())
        .containsExactly(
            request
                .replace("TOP/", top1 + File.separator)
                .replace("TOP", top1)
                .replace("ROOT", top.getRoot().toString()));
  }

  @Test
  void aStudyOfItsOwnFilesAsksForNothing() throws IOException {
    Files.createDirectories(folder.resolve("parts"));
    assertThat(
            asked(
                    """
                    "scene": "a.x3d", "form": "own.json", "allow": ["parts", "."],
                    "display": {"hmd": "wide.json"}, "tracker": "none",
                    "questionnaires": [{"file": "own.json"}]
                    """)
                .list())
        .isEmpty();
  }

  @Test
  @RequiresSymbolicLinks
  void aLinkThatLeadsOutsideIsARequest() throws IOException {
    Files.createSymbolicLink(folder.resolve("link.json"), top.resolve("own.json"));
    Files.createSymbolicLink(folder.resolve("folder"), top);
    Files.writeString(top.resolve("messages_xx.properties"), "");
    Files.createSymbolicLink(
        folder.resolve("messages_xx.properties"), top.resolve("messages_xx.properties"));
    assertThat(
            asked("\"form\": \"link.json\", \"allow\": [\"folder\"], \"language\": \"xx\"").list())
        .extracting(each -> each.key() + " " + each.target())
        .containsExactly(
            "form " + top1 + "/own.json",
            "language " + top1 + "/messages_xx.properties",
            "allow " + top1);
  }

  @Test
  void aChangeOfWhatIsAskedIsAnotherDigestAndAChangeOfTheRestIsNot() throws IOException {
    Set<String> before = asked("\"allow\": [\"..\"]").digests();
    assertThat(asked("\"fade\": 2, \"allow\": [\"../sent/..\"]").digests()).isEqualTo(before);
    assertThat(asked("\"allow\": [\"..\"], \"allowNet\": [\"a.org\"]").digests())
        .isNotEqualTo(before);
    assertThat(asked("\"allow\": [\"/\"]").digests()).isNotEqualTo(before);
  }

  @Test
  void nothingElseIsReadBeforeTheUserAgrees() throws IOException {
    Files.writeString(top.resolve("own.json"), "a private key");
    Path file = write("\"form\": \"../own.json\"");
    try {
      LoadedStudy.read(
          file,
          Optional.empty(),
          study -> {
            throw new IllegalStateException("not agreed");
          },
          problems);
    } catch (IllegalStateException e) {
      assertThat(problems.list()).isEmpty();
      return;
    }
    throw new AssertionError("the check was not made");
  }

  @Test
  void aPictureIsOfTheStudyOrOfAFolderThatItAsksFor() throws IOException {
    Files.writeString(folder.resolve("own.json"), PAGE.formatted("../p.png"));
    String keys = "\"questionnaires\": [{\"file\": \"own.json\"}]";
    assertThat(LoadedStudy.read(write(keys), problems)).isEmpty();
    assertThat(problems.list())
        .extracting(Problem::message)
        .first()
        .asString()
        .contains("the picture '../p.png' is outside of the study");
    assertThat(LoadedStudy.read(write("\"allow\": [\"..\"], " + keys), problems)).isPresent();
    Files.delete(folder.resolve("p.png"));
    Files.createSymbolicLink(folder.resolve("p.png"), top.resolve("p.png"));
    Files.writeString(folder.resolve("own.json"), PAGE.formatted("p.png"));
    assertThat(LoadedStudy.read(write(keys), problems)).as("a link").isEmpty();
  }

  @Test
  void aFileOfAnotherComputerIsNotEvenLookedFor() throws IOException {
    for (String name : List.of("//server/share/a.json", "\\\\\\\\server\\\\share\\\\a.json")) {
      for (String keys :
          Stream.of("\"form\": \"%s\"", "\"allow\": [\"%s\"]")
              .map(k -> k.formatted(name))
              .toList()) {
        ProblemCollector found = new ProblemCollector();
        assertThat(StudyReader.read(write(keys), found)).isEmpty();
        assertThat(found.list().toString()).contains("is on another computer");
      }
    }
  }

  @Test
  void aSceneOutsideIsNotReadBeforeTheAnswer() throws IOException {
    Path file =
        write(
            "\"scene\": \"../a.x3d\","
                + " \"areas\": [{\"name\": \"a\", \"viewpoint\": \"Gone\", \"seconds\": 1}]");
    assertThatThrownBy(
            () ->
                StudyReader.read(
                    file,
                    Optional.empty(),
                    study -> {
                      throw new IllegalStateException("refused");
                    },
                    problems))
        .hasMessage("refused");
    assertThat(StudyReader.read(file, Optional.empty(), study -> false, problems)).isPresent();
    assertThat(problems.list()).isEmpty();
    assertThat(StudyReader.read(file, Optional.empty(), study -> true, problems)).isEmpty();
    assertThat(problems.list().toString()).contains("no Viewpoint with the DEF 'Gone'");
  }
}
