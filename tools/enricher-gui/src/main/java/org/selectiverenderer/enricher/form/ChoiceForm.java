package org.selectiverenderer.enricher.form;

import java.util.Optional;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.enrichment.ChoiceMetadata;
import org.selectiverenderer.authoring.enrichment.EnrichedSwitch;
import org.selectiverenderer.authoring.enrichment.EnrichedSwitch.ChoiceNode;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.enricher.preview.VersionImage;
import org.selectiverenderer.enricher.preview.VersionImageRenderer;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.swing.PlainText;
import org.selectiverenderer.x3d.source.DocumentElement;

/** The form of one choice of a Switch (a row of thesis Fig 44): the version and its metadata. */
final class ChoiceForm {
  private final EnricherSession session;
  private final VersionImageRenderer pictures;
  private final DocumentElement element;
  private final ChoiceNode choice;
  private final JPanel panel =
      new JPanel(new MigLayout("insets 0, hidemode 3, wrap 4", "[][grow,fill][][fill]"));
  private final VersionThumbnail thumbnail;
  private final JLabel polygons = PlainText.only(new JLabel("\u2026"));
  private final JLabel title;
  private final JLabel url;
  private final MetadataControls metadata;
  private @Nullable VersionThumbnailLoader loading;

  ChoiceForm(
      EnricherSession session,
      VersionImageRenderer pictures,
      EnrichedSwitch node,
      ChoiceNode choice,
      JComponent buttons) {
    this.session = session;
    this.pictures = pictures;
    this.element = node.element();
    this.choice = choice;
    String number = String.valueOf(choice.index());
    metadata =
        new MetadataControls(
            session,
            new MetadataFormModel(session, () -> now().map(this::values), this::described),
            new MetadataControls.Names(
                Texts.of("form.type", number),
                Texts.of("form.degree", number),
                "Typed degree of choice " + number,
                Texts.of("form.schemas.of", number)));
    title = LabelFactory.of("", metadata.first());
    title.putClientProperty("FlatLaf.styleClass", "h4");
    if (choice.index() < 10) {
      title.setDisplayedMnemonic('0' + choice.index());
    }
    thumbnail = new VersionThumbnail(Texts.of("form.picture", number));
    url = new JLabel(PlainText.of(shortly(choice)));
    url.setToolTipText(PlainText.of(where(choice)));
    url.getAccessibleContext().setAccessibleName(Texts.of("form.model", number, where(choice)));
    polygons.setName("Polygons of choice " + number);
    polygons.getAccessibleContext().setAccessibleName(Texts.of("form.polygons", number));
    panel.add(title, "split 2, span, growx, pushx, wmin 0");
    panel.add(buttons, "growx 0");
    JPanel facts = new JPanel(new MigLayout("insets 0, wrap 1, gapy 2", "[grow,fill]"));
    facts.add(url, "wmin 0");
    facts.add(polygons, "wmin 0");
    panel.add(thumbnail, "split 2, span, growx 0");
    panel.add(facts, "growx, wmin 0");
    metadata.addTo(panel);
    panel.getAccessibleContext().setAccessibleName(Texts.of("form.choice", number));
    follow(node);
  }

  private Optional<EnrichedSwitch> now() {
    return session
        .enrichment()
        .switchNode(element)
        .filter(now -> choice.index() < now.choices().size());
  }

  private ChoiceMetadata values(EnrichedSwitch now) {
    return now.values().get(choice.index());
  }

  private Edit described(ChoiceMetadata wanted) {
    return session.edits().choice(now().orElseThrow(), choice.index(), wanted);
  }

  private static String where(ChoiceNode choice) {
    return choice.url().isEmpty()
        ? Texts.of("form.inscene", choice.element().toString())
        : choice.url();
  }

  /** The file name without its folders, which would push it out of view. */
  private static String shortly(ChoiceNode choice) {
    String where = where(choice);
    return choice.url().isEmpty() ? where : where.substring(where.lastIndexOf('/') + 1);
  }

  JComponent component() {
    return panel;
  }

  /** Requests the thumbnail, once the screen and thus its resolution are known. */
  void load() {
    if (loading == null) {
      loading =
          new VersionThumbnailLoader(
              session, pictures, thumbnail.pixels(), this::taken, this::failed);
      loading.begin(choice);
    }
  }

  private void taken(VersionImage picture) {
    thumbnail.show(picture.image());
    String text =
        Texts.of(
            "counts.polygons", picture.polygons(), DecimalFormatter.grouped(picture.polygons()));
    polygons.setText(text);
    polygons.getAccessibleContext().setAccessibleName(text);
  }

  private void failed(String sentence) {
    polygons.setText(sentence);
    polygons.setToolTipText(PlainText.of(sentence));
    polygons.getAccessibleContext().setAccessibleName(sentence);
  }

  /** Whether this is the form of a choice. */
  boolean fits(ChoiceNode other) {
    return choice.element() == other.element() && choice.url().equals(other.url());
  }

  void follow(EnrichedSwitch node) {
    title.setText(
        Texts.of(
            node.whichChoice() == choice.index() ? "form.choice.start" : "form.choice",
            String.valueOf(choice.index())));
    metadata.follow();
  }

  void commit() {
    metadata.commit();
  }

  void dispose() {
    metadata.close();
    if (loading != null) {
      loading.cancel();
    }
  }
}
