package org.selectiverenderer.enricher.versions;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.EventQueue;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import javax.imageio.ImageIO;
import javax.swing.JTextField;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.authoring.enrichment.EnrichedField;
import org.selectiverenderer.authoring.enrichment.EnrichedSwitch;
import org.selectiverenderer.authoring.file.DocumentFile;
import org.selectiverenderer.authoring.qualities.QualityVersionsEdit;
import org.selectiverenderer.enricher.EventThread;
import org.selectiverenderer.enricher.robot.TestSessions;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.task.TaskExecutor;
import org.selectiverenderer.testing.Eventually;
import org.selectiverenderer.testing.robot.GuiRobot;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;

class QualityLevelsMakerTest {
  @TempDir Path folder;

  @Test
  void picturesAndLevelsAreOneStep() throws IOException {
    ImageIO.write(
        new BufferedImage(8, 8, BufferedImage.TYPE_INT_RGB),
        "png",
        folder.resolve("wood.png").toFile());
    EnricherSession session =
        TestSessions.with(
            folder,
            """
            <Switch DEF='Switch_Chest' whichChoice='0'>
              <Shape><Appearance><ImageTexture url='"wood.png"'/></Appearance><Box/></Shape>
            </Switch>
            """);
    String before = EventThread.get(() -> session.document().text().toString());
    EventThread.edt(
        () ->
            new QualityLevelsMaker(session)
                .make(
                    new QualityVersionsEdit.Request(
                        "Switch_Chest", List.of(50.0), List.of("flat"), List.of())));
    Eventually.await("the levels", () -> EventThread.get(() -> session.document().revision() > 0));
    EnrichedSwitch chest = EventThread.get(() -> session.enrichment().switches().get(0));
    assertThat(chest.fields()).hasSize(2);
    assertThat(chest.fields().get(0).levels())
        .extracting(EnrichedField.Level::values)
        .containsExactly(List.of("wood.png"), List.of("wood_50.png"));
    assertThat(ImageIO.read(folder.resolve("wood_50.png").toFile()).getWidth()).isEqualTo(4);
    assertThat(EventThread.get(() -> session.document().history().undoName()))
        .contains("Set qualities of Switch_Chest");
    EventThread.edt(() -> session.document().history().undo());
    assertThat(EventThread.get(() -> session.document().text().toString())).isEqualTo(before);
    assertThat(Files.exists(folder.resolve("wood_50.png"))).isFalse();
    EventThread.edt(session::dispose);
  }

  @Test
  void percentsFallFromBelowAHundred() {
    assertThat(QualityLevelsPanel.percents("50, 25")).contains(List.of(50.0, 25.0));
    assertThat(QualityLevelsPanel.percents("50 % 12.5 %")).contains(List.of(50.0, 12.5));
    assertThat(QualityLevelsPanel.percents(" ")).contains(List.of());
    assertThat(QualityLevelsPanel.percents("25, 50")).isEqualTo(Optional.empty());
    assertThat(QualityLevelsPanel.percents("100")).isEqualTo(Optional.empty());
    assertThat(QualityLevelsPanel.percents("half")).isEqualTo(Optional.empty());
  }

  @Test
  void moreLevelsThanTheDialogOfVersionsHasAreRefused() {
    assertThat(QualityLevelsPanel.percents("90 80 70 60 50 40 30 20")).isPresent();
    assertThat(QualityLevelsPanel.percents("90 80 70 60 50 40 30 20 10")).isEmpty();
  }

  @Test
  void anObjectWhosePicturesAreElsewhereIsNamedWithoutTheScenesPath() throws IOException {
    assertThat(said("<Group/>"))
        .isEqualTo("'Switch_Chest' has no ImageTexture with a picture of its own");
    assertThat(said("<Inline url='\"chest_v1.x3d\"'/>"))
        .isEqualTo(
            "'Switch_Chest' has no ImageTexture with a picture in this file; make them in the"
                + " files of its versions: \"chest_v1.x3d\"");
  }

  @Test
  void aPictureThatCannotBeReducedIsNamed() throws IOException {
    wood();
    byte[] damaged = Files.readAllBytes(folder.resolve("wood.png"));
    Arrays.fill(damaged, damaged.length / 2, damaged.length, (byte) 0);
    Files.write(folder.resolve("wood.png"), damaged);
    assertThat(said(CHEST)).contains("wood.png is a damaged picture");
    Files.delete(folder.resolve("wood.png"));
    assertThat(said(CHEST)).contains("no url of this ImageTexture is a file of this scene");
  }

  @Test
  void aFolderInTheWayLeavesTheSceneAsItIs() throws IOException {
    wood();
    Files.createDirectory(folder.resolve("wood_50.png"));
    assertThat(said(CHEST)).contains("wood_50.png exists already and is another picture");
  }

  @Test
  void whatWasMadeAndWhatWasLeftOutIsSaid() throws IOException {
    wood();
    assertThat(said(CHEST))
        .isEqualTo("Levels of Switch_Chest made; new pictures: wood_50.png.");
    String other =
        "<Shape><Appearance><ImageTexture url='\"http://localhost/x.png\"'/></Appearance></Shape>";
    assertThat(said("<Group>" + CHEST + other + "</Group>"))
        .isEqualTo(
            "scene.x3d:1:174: no url of this ImageTexture is a file of this scene; it gets no smaller"
                + " picture");
    assertThat(Files.exists(folder.resolve("wood_50.png"))).isTrue();
  }

  @Test
  void schemasOfLevelsThatAreReplacedStayUnlessTheAuthorSaysOtherwise() throws IOException {
    TestSessions.theme(false);
    String level =
        "<MetadataSet containerField='value'><MetadataString containerField='value'"
            + " name='schemaBelonginess' value='\"%s\"'/><MetadataString containerField='value'"
            + " name='value' value='\"wood.png\"'/></MetadataSet>";
    EnricherSession session =
        TestSessions.with(
            folder,
            "<Switch DEF='Switch_Chest' whichChoice='0'><MetadataSet containerField='metadata'>"
                + "<MetadataSet containerField='metadata' name='fieldQualities'>"
                + "<MetadataSet containerField='value'><MetadataString containerField='value'"
                + " name='quality' value='\"textures\"'/><MetadataString containerField='value'"
                + " name='field' value='\"Wood.url\"'/>"
                + level.formatted("Hall")
                + level.formatted("Attic")
                + "</MetadataSet></MetadataSet></MetadataSet>"
                + CHEST.replace("<ImageTexture", "<ImageTexture DEF='Wood'")
                + "</Switch>");
    QualityLevelsPanel panel =
        EventThread.get(
            () -> new QualityLevelsPanel(session.enrichment().switches().get(0).fields()));
    JTextField schemas = GuiRobot.named(panel, "Schemas, the best level's first", JTextField.class);
    JTextField percents = GuiRobot.named(panel, "Sides of textures in percent", JTextField.class);
    assertThat(EventThread.get(() -> schemas.getText())).isEqualTo("Hall, Attic");
    assertThat(EventThread.get(panel::complaint))
        .contains("Name 3 schemas, one for each level, or none; there are 2");
    EventThread.edt(() -> percents.setText("50"));
    assertThat(EventThread.get(panel::complaint)).isEmpty();
    assertThat(EventThread.get(() -> panel.request("Switch_Chest")).schemas())
        .containsExactly("Hall", "Attic");
    EventThread.edt(
        () -> {
          percents.setText("50, 25");
          schemas.setText("");
        });
    assertThat(EventThread.get(panel::complaint)).isEmpty();
    EventThread.edt(session::dispose);
  }

  private static final String CHEST =
      "<Shape><Appearance><ImageTexture url='\"wood.png\"'/></Appearance><Box/></Shape>";

  private void wood() throws IOException {
    ImageIO.write(
        new BufferedImage(8, 8, BufferedImage.TYPE_INT_RGB),
        "png",
        folder.resolve("wood.png").toFile());
  }

  /** Returns what is said when levels of a chest are made. */
  private String said(String chest) throws IOException {
    String scene =
        "<X3D version='4.0'><Scene><Switch DEF='Switch_Chest' whichChoice='0'>%s</Switch></Scene></X3D>"
            .formatted(chest);
    List<String> messages = new CopyOnWriteArrayList<>();
    EnricherSession session =
        new EnricherSession(
            DocumentFile.open(Files.writeString(folder.resolve("scene.x3d"), scene)),
            NodeCatalogue.load(),
            new TaskExecutor(EventQueue::invokeLater),
            messages::add);
    EventThread.edt(
        () ->
            new QualityLevelsMaker(session)
                .make(
                    new QualityVersionsEdit.Request(
                        "Switch_Chest", List.of(50.0), List.of(), List.of())));
    Eventually.await("a message", () -> !messages.isEmpty());
    EventThread.edt(session::dispose);
    return messages.get(0);
  }
}
