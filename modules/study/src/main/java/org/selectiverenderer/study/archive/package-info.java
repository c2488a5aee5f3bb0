/**
 * A study as an anonymised package for an archive: its tables without what could tell who took
 * part, its files, README, codebook, licence and checksums in one zip file.
 *
 * <p>In: the tables of {@code study.export}, of one folder or of several sites, and the study. Out:
 * an {@link org.selectiverenderer.study.archive.ArchivePackage}. Ids are given by chance, and
 * nothing keeps which was which; times are moved by a constant for each participant; notes, free
 * texts, places of the schedule and names of files are left out, and all of those who refused. Uses
 * {@code study.dataset}, {@code study.export} and {@code study.session}.
 */
@NullMarked
package org.selectiverenderer.study.archive;

import org.jspecify.annotations.NullMarked;
