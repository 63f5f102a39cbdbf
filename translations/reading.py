#!/usr/bin/env python3
"""Texts of a language drawn at random, with the words that terms.csv wants in them, to be read by somebody who knows
the field. usage: translations/reading.py LANGUAGE [COUNT [SEED]]      (100 texts; the seed is printed)"""
import csv
import pathlib
import random
import re
import sys
import xml.etree.ElementTree

HERE = pathlib.Path(__file__).parent


def messages(language):
    for context in xml.etree.ElementTree.parse(HERE / f"stepwise_{language}.ts").getroot().findall("context"):
        for message in context.findall("message"):
            translation = message.find("translation")
            forms = [form.text or "" for form in translation.findall("numerusform")] or [translation.text or ""]
            yield context.findtext("name").split("::")[-1], message.findtext("source"), forms


def terms_in(source, language, table):
    for row in table:
        words = "|".join(re.escape(word) for word in row["term"].split("|"))
        if re.search(rf"\b({words})", source, re.IGNORECASE):
            yield f"{row['term'].split('|')[0]} = {row[language].split('|')[0]} ({row['source']})"


def main():
    language = sys.argv[1]
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 100
    seed = int(sys.argv[3]) if len(sys.argv) > 3 else random.SystemRandom().randrange(1_000_000)
    print(f"{language}, seed {seed}")
    with open(HERE / "terms.csv", encoding="utf8") as file:
        table = list(csv.DictReader(file))
    for context, source, forms in random.Random(seed).sample(list(messages(language)), count):
        print(f"\n{context}: {source}\n  {' / '.join(forms)}")
        for term in terms_in(source, language, table):
            print(f"    {term}")


if __name__ == "__main__":
    main()
