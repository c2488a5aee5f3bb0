package org.selectiverenderer.export.study;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.study.session.LoadedStudy;

/** Writes a small study in two languages, about a desk in a room, and reads it. */
final class StudyFixture {
  private final Path folder;
  private final ProblemCollector problems = new ProblemCollector();

  StudyFixture(Path folder) throws IOException {
    this.folder = folder;
    Files.writeString(
        folder.resolve("room.x3d"),
        """
        <X3D profile='Immersive' version='3.3'><head/><Scene>
          <Viewpoint DEF='DeskView' position='0 1.6 3'/>
          <ProximitySensor DEF='DeskProx' size='9 9 9'>
            <MetadataString name='enterTimeSchema' value='"DeskSchema"'/></ProximitySensor>
          <Switch DEF='Switch_Lamp' whichChoice='1'>
            <MetadataSet>
              <MetadataSet><MetadataString name='schemaBelonginess' value='"DeskSchema"'/></MetadataSet>
              <MetadataSet><MetadataString name='consistencyType' value='"Consistent"'/></MetadataSet>
            </MetadataSet>
            <Shape><Box/></Shape><Shape><Sphere/></Shape></Switch>
        </Scene></X3D>
        """);
    Files.writeString(
        folder.resolve("list.csv"),
        """
        area,object,consistency,present,en,el
        desk,lamp,consistent,yes,lamp,λάμπα
        desk,kettle,inconsistent,no,kettle,βραστήρας
        desk,pen,consistent,no,pen,στυλό
        """);
    Files.writeString(
        folder.resolve("closing.json"),
        """
        {"name": "closing", "pages": [{"title": {"en": "The end", "el": "Τέλος"}, "questions": [
          {"id": "noticed", "kind": "yes-no", "text": {"en": "Did things change?", "el": "Άλλαξε κάτι;"}},
          {"id": "what", "kind": "text", "optional": true, "when": {"question": "noticed", "is": ["yes"]},
            "text": {"en": "What <b>changed</b>?", "el": "Τι άλλαξε;"}}]}]}
        """);
  }

  /** Returns the text of the study with further lines before its areas. */
  static String text(String lines) {
    return """
        {
          "name": "Desk",
          "languages": ["en", "el"],
          "scene": "room.x3d",
          "conditions": ["high", "selective"],
          "participants": 4,
          "seed": 3,
        %s  "areas": [{"name": "desk", "viewpoint": "DeskView", "seconds": 2}],
          "questionnaires": [{"kind": "recognition", "items": "list.csv"}, {"file": "closing.json"}]
        }
        """
        .formatted(lines);
  }

  /** Reads a study with this text, in both languages. */
  List<LoadedStudy> read(String text) throws IOException {
    Path file = Files.writeString(folder.resolve("study.json"), text);
    Optional<List<LoadedStudy>> read =
        LoadedStudy.readAll(file, Optional.empty(), study -> true, problems);
    return read.orElseThrow(() -> new IllegalArgumentException(problems().toString()));
  }

  ProblemCollector collector() {
    return problems;
  }

  /** Returns the problems, without the folder. */
  List<String> problems() {
    return problems.list().stream()
        .map(Problem::toString)
        .map(line -> line.replace(folder + "/", ""))
        .toList();
  }
}
