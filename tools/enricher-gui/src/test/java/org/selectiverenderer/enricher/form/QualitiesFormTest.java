package org.selectiverenderer.enricher.form;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.awt.event.KeyEvent;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.concurrent.TimeUnit;
import javax.swing.AbstractButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.text.JTextComponent;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.ResourceLock;
import org.junit.jupiter.api.parallel.Resources;
import org.selectiverenderer.authoring.enrichment.EnrichedSwitch;
import org.selectiverenderer.authoring.enrichment.QualityEdits;
import org.selectiverenderer.enricher.EventThread;
import org.selectiverenderer.schema.FieldReference;
import org.selectiverenderer.testing.Eventually;
import org.selectiverenderer.testing.ShowsWindows;

@ShowsWindows
@Timeout(value = 120, unit = TimeUnit.SECONDS)
class QualitiesFormTest {
  private static final String SCENE =
      """
      <?xml version="1.0" encoding="UTF-8"?>
      <X3D profile='Immersive' version='4.0'><Scene>
        <Switch DEF='Switch_Bin' whichChoice='0'>
          <MetadataSet containerField='metadata' name='Bin'>
            <MetadataSet containerField='metadata' name='fieldQualities'>
              <MetadataSet containerField='value'>
                <MetadataString containerField='value' name='quality' value='"light"'/>
                <MetadataString containerField='value' name='field' value='"Paint.transparency"'/>
                <MetadataSet containerField='value'>
                  <MetadataString containerField='value' name='schemaBelonginess' value='"Desk"'/>
                  <MetadataString containerField='value' name='value' value='"0"'/>
                </MetadataSet>
                <MetadataSet containerField='value'>
                  <MetadataString containerField='value' name='schemaBelonginess' value='"Hall"'/>
                  <MetadataString containerField='value' name='value' value='"0.5"'/>
                </MetadataSet>
              </MetadataSet>
            </MetadataSet>
          </MetadataSet>
          <Shape DEF='Bin'><Appearance><Material DEF='Paint'/></Appearance><Box/></Shape>
        </Switch>
        <Shape><Appearance><ImageTexture DEF='Wallpaper' url='"wall.png"'/></Appearance><Box/></Shape>
      </Scene></X3D>
      """;

  /** The width of the form in a window of 800 pixels. */
  private static final int NARROW = 270;

  private static final String VALUE = "Value of level 2 of quality 1";

  @TempDir Path folder;

  private FormWindowDriver open(boolean dark) throws Exception {
    FormWindowDriver window =
        new FormWindowDriver(Files.writeString(folder.resolve("scene.x3d"), SCENE), dark);
    window.select("Switch_Bin");
    return window;
  }

  private static Object outline(Component control) {
    return EventThread.get(() -> ((JComponent) control).getClientProperty("JComponent.outline"));
  }

  private static void reveal(Component control) {
    EventThread.edt(
        () -> ((JComponent) control.getParent()).scrollRectToVisible(control.getBounds()));
  }

  private static String undo(FormWindowDriver window) {
    return EventThread.get(() -> window.session.document().history().undoName().orElse("nothing"));
  }

  @Test
  void aValueIsCheckedByItsFieldAndWrittenAsOneStep() throws Exception {
    try (FormWindowDriver window = open(false)) {
      JTextComponent value = (JTextComponent) window.named(VALUE);
      reveal(value);
      assertThat(text(value)).isEqualTo("0.5");
      window.fill(value, "2");
      window.press(KeyEvent.VK_ENTER);
      assertThat(outline(value)).isEqualTo("error");
      assertThat(window.text("Switch_Bin")).isEqualTo(text("Switch_Bin"));
      window.fill(value, "0.25");
      window.press(KeyEvent.VK_ENTER);
      assertThat(outline(value)).isNull();
      assertThat(window.text("Switch_Bin"))
          .isEqualTo(text("Switch_Bin").replace("\"0.5\"", "\"0.25\""));
      assertThat(undo(window)).isEqualTo("Set level 2 of Paint.transparency");
      EventThread.edt(() -> window.session.document().history().undo());
      assertThat(text(value)).isEqualTo("0.5");
    }
  }

  private static String text(JTextComponent control) {
    return EventThread.get(() -> control.getText());
  }

  /** The text of an element in the scene as it was opened. */
  private static String text(String def) {
    int from = SCENE.indexOf("<Switch DEF='" + def);
    return SCENE.substring(from, SCENE.indexOf("</Switch>") + "</Switch>".length());
  }

  @Test
  void aNewQualityIsChosenFromProposalsThatWork() throws Exception {
    try (FormWindowDriver window = open(true)) {
      TargetField target = (TargetField) window.named("Field of a new quality");
      reveal(target);
      window.fill(target, "wall");
      Eventually.await("proposals", () -> EventThread.get(() -> target.proposing()));
      window.press(KeyEvent.VK_ENTER); // the only node
      Eventually.await("its fields", () -> EventThread.get(() -> target.proposing()));
      assertThat(text(target)).isEqualTo("Wallpaper.");
      window.screenshot("qualities-proposals", 1);
      window.type("url");
      Eventually.await("the list to close", () -> !EventThread.get(() -> target.proposing()));
      assertThat(text(target)).isEqualTo("Wallpaper.url");
      EventThread.edt(((AbstractButton) window.named("Add quality"))::doClick);
      assertThat(undo(window)).isEqualTo("Add the quality textures to Switch_Bin");
      JTextComponent first = (JTextComponent) window.named("Value of level 1 of quality 2");
      assertThat(text(first)).isEqualTo("\"wall.png\"");
      assertThat(outline(first)).isNull();
      Component second = window.named("Value of level 2 of quality 2");
      assertThat(outline(second)).isEqualTo("error");
      assertThat(second.getAccessibleContext().getAccessibleDescription())
          .isEqualTo("Level 1 has this value already: the two levels look the same");
      JComboBox<?> quality = (JComboBox<?>) window.named("Quality 2");
      assertThat(EventThread.get(() -> quality.getSelectedItem())).isEqualTo("textures");
      EventThread.edt(((AbstractButton) window.named("Remove quality 1"))::doClick);
      assertThat(window.text("Switch_Bin")).doesNotContain("Paint.transparency");
      EventThread.edt(((AbstractButton) window.named("Remove quality 1"))::doClick);
      assertThat(window.text("Switch_Bin")).doesNotContain("Metadata");
    }
  }

  @Test
  void whatIsWrongInTheDocumentIsMarkedWhereItStands() throws Exception {
    try (FormWindowDriver window = open(false)) {
      Component target = window.named("Field of quality 1");
      assertThat(outline(target)).isNull();
      EventThread.edt(
          () -> {
            EnrichedSwitch bin = window.session.enrichment().switches().get(0);
            window.session.perform(
                new QualityEdits(window.session.document())
                    .target(
                        bin, bin.fields().get(0), new FieldReference("Varnish", "transparency")));
          });
      assertThat(outline(target)).isEqualTo("error");
      assertThat(target.getAccessibleContext().getAccessibleDescription())
          .isEqualTo("No node of this file has the name Varnish.");
    }
  }

  @Test
  void theFormFitsItsWindow() throws Exception {
    for (boolean dark : new boolean[] {false, true}) {
      try (FormWindowDriver window = open(dark)) {
        JComponent schemas = (JComponent) window.named("Schemas of level 2 of quality 1");
        reveal(schemas);
        window.screenshot(dark ? "qualities-dark" : "qualities", dark ? 2 : 1);
        assertThat(EventThread.get(() -> schemas.getVisibleRect().width))
            .isEqualTo(schemas.getWidth());
      }
    }
  }

  @Test
  @ResourceLock(Resources.LOCALE)
  void aNarrowGreekFormCutsNoControlOff() throws Exception {
    Locale before = Locale.getDefault(Locale.Category.DISPLAY);
    Locale.setDefault(Locale.Category.DISPLAY, Locale.forLanguageTag("el"));
    try (FormWindowDriver window = open(false)) {
      Component remove = window.named("Αφαίρεση της ποιότητας 1");
      JComponent form = (JComponent) remove.getParent().getParent().getParent();
      int least = EventThread.get(() -> form.getMinimumSize().width);
      assertThat(least).isLessThanOrEqualTo(NARROW * form.getFont().getSize() / 13);
    } finally {
      Locale.setDefault(Locale.Category.DISPLAY, before);
    }
  }
}
