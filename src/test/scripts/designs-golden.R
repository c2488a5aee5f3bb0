# Makes designs-golden.csv; see README.md beside this file.
suppressMessages(library(afex))
arguments <- commandArgs(trailingOnly = TRUE)
folder <- arguments[1]
lines <- "design,effect,df1,df2,F,ges,p"

analyse <- function(label, design, measure, between = NULL, within = NULL, where = function(d) d) {
  d <- where(read.csv(file.path(folder, paste0(design, ".csv")), colClasses = c(participant = "character")))
  d$value <- as.numeric(d[[measure]])
  # The mean of a participant's trials at the same levels.
  d <- aggregate(d["value"], d[c("participant", between, within)], mean)
  for (name in c(between, within)) d[[name]] <- factor(d[[name]])
  # Greenhouse and Geisser's correction of p is not applied, as by --sphericity none.
  table <- suppressMessages(suppressWarnings(aov_ez("participant", "value", d, between = between, within = within,
    anova_table = list(correction = "none", es = "ges"), check_contrasts = TRUE)))$anova_table
  for (effect in rownames(table))
    lines <<- c(lines, sprintf("%s,%s,%.15g,%.15g,%.15g,%.15g,%.15g", label, effect, table[effect, "num Df"],
      table[effect, "den Df"], table[effect, "F"], table[effect, "ges"], table[effect, "Pr(>F)"]))
}

right <- function(d) d[d$correct == "yes", ]
scored <- function(d) { d$correct <- as.numeric(d$correct == "yes"); d }
analyse("between", "rooms-between", "there.there", between = "quality")
analyse("mixed", "rooms-between", "there.there", between = "quality", within = "area")
analyse("time", "quality-and-light", "ms", within = c("quality", "light"), where = right)
analyse("share", "quality-and-light", "correct", within = c("quality", "light"), where = scored)
analyse("change", "change-blindness", "ms", within = "change", where = right)
analyse("staircase", "levels-of-detail", "corners", within = "side")
writeLines(lines, arguments[2])
