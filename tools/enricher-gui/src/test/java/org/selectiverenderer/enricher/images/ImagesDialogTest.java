package org.selectiverenderer.enricher.images;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JTable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.enricher.robot.TestSessions;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.testing.ShowsWindows;
import org.selectiverenderer.testing.robot.GuiRobot;

@ShowsWindows
class ImagesDialogTest {
  private static final String SCENE =
      """
        <Shape><Appearance><ImageTexture url='"wood.png"'/></Appearance><Box/></Shape>
        <Shape><Appearance><ImageTexture url='"wood.png"'/></Appearance><Box/></Shape>
        <Shape><Appearance><ImageTexture url='"old/stone.png"'/></Appearance><Box/></Shape>
        <Shape><Appearance><ImageTexture url='"text.png"'/></Appearance><Box/></Shape>
      """;

  @TempDir Path folder;

  private Path image(String name, int width, int height) throws IOException {
    Path file = folder.resolve(name);
    Files.createDirectories(file.getParent());
    BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
    for (int x = 0; x < width; x++) {
      image.setRGB(x, height / 2, 0xff8800);
    }
    ImageIO.write(image, "png", file.toFile());
    return file;
  }

  @Test
  void imagesHaveSizesAndMissingOnesAreFoundInOneStep() throws IOException {
    TestSessions.theme(false);
    image("wood.png", 300, 200);
    image("maps/deep/Stone.png", 64, 64);
    Files.writeString(folder.resolve("text.png"), "no image");
    EnricherSession session = TestSessions.with(folder, SCENE);
    String before = session.document().text().toString();
    GuiRobot hands = new GuiRobot();
    ImagesDialog dialog = GuiRobot.onEdt(() -> new ImagesDialog(null, session));
    hands.show(dialog);
    JTable table = GuiRobot.named(dialog, "Images of the scene", JTable.class);
    hands.await("the images", () -> table.getRowCount() == 3);
    assertThat(cell(table, 0, ImagesTableModel.FILE)).isEqualTo("old/stone.png");
    assertThat(cell(table, 0, ImagesTableModel.STATE)).isEqualTo("the file is missing");
    assertThat(cell(table, 1, ImagesTableModel.STATE)).contains("no image of a known format");
    assertThat(cell(table, 2, ImagesTableModel.PIXELS)).isEqualTo("300 \u00d7 200");
    assertThat(cell(table, 2, ImagesTableModel.CARD)).isEqualTo("320 KB");
    assertThat(cell(table, 2, ImagesTableModel.USES)).isEqualTo("2");
    JLabel state = GuiRobot.named(dialog, "Number and size of the images", JLabel.class);
    assertThat(GuiRobot.onEdt(state::getText)).startsWith("3 images").endsWith("1 missing");
    GuiRobot.picture(dialog.getContentPane(), "images", 1);
    assertThat(GuiRobot.onEdt(GuiRobot.named(dialog, "Find...", JButton.class)::isEnabled))
        .isTrue();

    GuiRobot.onEdt(
        () -> {
          dialog.find(folder);
          return null;
        });
    hands.await(
        "the stone",
        () ->
            table.getRowCount() == 3
                && "64 \u00d7 64".equals(table.getValueAt(2, ImagesTableModel.PIXELS)));
    assertThat(session.document().text().toString())
        .isEqualTo(before.replace("old/stone.png", "maps/deep/Stone.png"));
    assertThat(session.document().history().names()).containsExactly("Find missing images");
    session.document().history().undo();
    assertThat(session.document().text().toString()).isEqualTo(before);
    hands.click(GuiRobot.named(dialog, "Close", JButton.class));
    hands.await("the end", () -> !dialog.isShowing());
  }

  @Test
  void theBallHasTheColourOfTheMaterialAndShowsTheGroundWhereItIsTransparent() {
    float[] red = {1, 0, 0};
    float[] black = {0, 0, 0};
    BufferedImage ball =
        MaterialBall.picture(new MaterialBall.Look(red, black, black, 0.2, 20, 0), 64);
    int centre = ball.getRGB(32, 32);
    assertThat(centre >> 16 & 255).isGreaterThan(120);
    assertThat(centre & 0xffff).isZero();
    assertThat(ball.getRGB(0, 0) >>> 24).isZero();
    BufferedImage glass =
        MaterialBall.picture(new MaterialBall.Look(red, black, black, 0.2, 20, 1), 64);
    assertThat(glass.getRGB(32, 32) >> 8 & 255).isGreaterThan(100);
  }

  private static String cell(JTable table, int row, int column) {
    return GuiRobot.onEdt(() -> String.valueOf(table.getValueAt(row, column)));
  }
}
